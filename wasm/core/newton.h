#pragma once

#include <Eigen/SparseCholesky>

#include "standing.h"
#include "time_step.h"
#include "types.h"

namespace mass_spring {

/// Newton's method with the exact Hessian and a line search: run to its end, the minimiser against
/// which every other method is measured. Where the exact Hessian gives no step that lowers E, not
/// being positive definite, a share of the springs' negative curvature is left out: as little as
/// will do, since with all of it left out the last digits take hundreds of iterations.
///
/// Since it compares objectives by objective_change, it ends only where the rounding of ∂E/∂p, not
/// that of E, hides the way down. At a pin that leaves forces of w |p| 1e-16, N, but distances of
/// |p| 1e-16 only. Unlike the other methods, every iteration allocates and factorises; the factor
/// has about nine times the entries of Q's.
class Newton {
 public:
  void begin(const TimeStep& step, const Points& p);

  /// @param step  as at begin
  /// @param p  #V by 3, m (updated)
  /// @return whether p changed; if not, it is a minimiser up to rounding
  bool iterate(const TimeStep& step, Points& p);

  const Standing<Points>& standing() const { return standing_; }

 private:
  void evaluate(const TimeStep& step, const Points& p);
  bool descend(const TimeStep& step, double left_out, Points& p);

  Standing<Points> standing_;
  std::size_t caution_ = 0;                 // which share of negative curvature to leave out
  Eigen::SimplicialLLT<SparseMatrix> llt_;  // of H, 3#V by 3#V, N/m
  Points x_;                                // #V by 3, m: H⁻¹ ∂E/∂p
  Points q_;                                // #V by 3, m: a candidate for the next iterate
};

}  // namespace mass_spring
