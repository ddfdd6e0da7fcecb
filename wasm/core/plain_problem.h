#pragma once

#include "gradient.h"
#include "largest_free_component.h"
#include "objective.h"
#include "precomputation.h"
#include "time_step.h"

namespace mass_spring {

/// One time step as the methods of descent see it (descent.h), on the functions that the course
/// spells out. Lends both arguments.
/// @tparam Precomputation  SparsePrecomputation or DensePrecomputation
template <typename Precomputation>
class PlainProblem {
 public:
  using Field = Points;
  using Direction = Points;

  /// @param precomputation  of the same springs, masses, pins, k, Δt and w
  PlainProblem(const TimeStep& step, const Precomputation& precomputation)
      : step_(step), precomputation_(precomputation) {}

  /// @param p  #V by 3, m
  /// @param g  #V by 3, N (result): ∂E/∂p
  /// @return E(p), J
  double objective_and_gradient(const Points& p, Points& g) const {
    gradient(step_, p, g);
    return objective(step_, p).objective;
  }
  /// J: what is left out of E(p).
  double objective_offset() const { return 0; }

  /// @param g  #V by 3, N
  /// @param x  #V by 3, m (result): Q⁻¹ g
  void apply_inverse(const Points& g, Points& x) { precomputation_.Q.solve(g, scratch_, x); }

  /// N: without the pinned vertices, whose penalty leaves w |p| 1e-16.
  double gradient_norm(const Points& g) const { return largest_free_component(g, step_.pinned); }

  const Points& field_from_points(const Points& p) const { return p; }
  void points_from_field(const Points& field, Points& p) const { p = field; }

 private:
  const TimeStep& step_;
  const Precomputation& precomputation_;
  DenseMatrix scratch_;  // #V by 3
};

using SparseProblem = PlainProblem<SparsePrecomputation>;
using DenseProblem = PlainProblem<DensePrecomputation>;

}  // namespace mass_spring
