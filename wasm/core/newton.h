#pragma once

#include <Eigen/SparseCholesky>

#include "largest_free_component.h"
#include "spring_blocks.h"
#include "standing.h"
#include "time_step.h"
#include "types.h"

namespace mass_spring {

enum class Pins { penalised, held };

/// A time step as Newton's method sees it. Lends the step.
class NewtonProblem {
 public:
  using Field = Points;

  NewtonProblem(const TimeStep& step, Pins pins = Pins::penalised) : step_(step), pins_(pins) {}

  const TimeStep& step() const { return step_; }
  bool holds_pins() const { return pins_ == Pins::held; }

  /// J: what is left out of E(p).
  double objective_offset() const { return 0; }
  double gradient_norm(const Points& g) const { return largest_free_component(g, step_.pinned); }
  /// #V by 3, m: with held pins where they are held
  Points field_from_points(Points p) const;
  void points_from_field(const Points& field, Points& p) const { p = field; }

 private:
  const TimeStep& step_;
  Pins pins_;
};

/// Newton's method with the exact Hessian and a line search: run to its end, the minimiser against
/// which every other method is measured. Where the exact Hessian gives no step that lowers E, not
/// being positive definite, a share of the springs' negative curvature is left out: as little as
/// will do, since with all of it left out the last digits take hundreds of iterations.
///
/// Since it compares objectives by objective_change, it ends only where the rounding of ∂E/∂p, not
/// that of E, hides the way down. At a pin that leaves forces of w |p| 1e-16, N, but distances of
/// |p| 1e-16 only. Unlike the other methods, every iteration factorises; the factor
/// has about nine times the entries of Q's.
class Newton {
 public:
  /// @param problem  as long as it has the springs and pins of the one before, the pattern of H is
  /// analysed once
  /// @param p  #V by 3, m; where pins are held, they have to be there
  void begin(const NewtonProblem& problem, const Points& p);

  /// @param problem  as at begin
  /// @param p  #V by 3, m (updated)
  /// @return whether p changed; if not, it is a minimiser up to rounding
  bool iterate(const NewtonProblem& problem, Points& p);

  const Standing<Points>& standing() const { return standing_; }

 private:
  /// `ended`: H is positive definite, and still its step does not lower E by more than rounding.
  enum class Descent { moved, ended, not_convex };

  void evaluate(const NewtonProblem& problem, const Points& p);
  Descent descend(const NewtonProblem& problem, double left_out, Points& p);

  Standing<Points> standing_;
  std::size_t caution_ = 0;                 // which share of negative curvature to leave out
  SpringBlocks H_;                          // #unknowns by #unknowns, N/m
  Eigen::SimplicialLLT<SparseMatrix> llt_;  // of H
  Vector g_;                                // #unknowns: ∂E/∂p, N, then H⁻¹ ∂E/∂p, m
  Points x_;                                // #V by 3, m: H⁻¹ ∂E/∂p
  Points q_;                                // #V by 3, m: a candidate for the next iterate
};

}  // namespace mass_spring
