#pragma once

#include "gradient.h"
#include "objective.h"
#include "precomputation.h"
#include "time_step.h"

namespace mass_spring {

/// One time step as the methods of descent see it (descent.h), on the functions that the course
/// spells out. Lends both arguments.
class PlainProblem {
 public:
  using Field = Points;

  /// @param precomputation  of fast_mass_springs_precomputation_sparse for the same springs,
  /// masses, pins, k, Δt and w
  PlainProblem(const TimeStep& step, const SparsePrecomputation& precomputation)
      : step_(step), precomputation_(precomputation) {}

  /// @param p  #V by 3, m
  /// @param g  #V by 3, N (result): ∂E/∂p
  /// @return E(p), J
  double objective_and_gradient(const Points& p, Points& g) const {
    gradient(step_, p, g);
    return objective(step_, p).objective;
  }

  /// @param g  #V by 3, N
  /// @param x  #V by 3, m (result): Q⁻¹ g
  void apply_inverse(const Points& g, Points& x) { precomputation_.Q.solve(g, scratch_, x); }

 private:
  const TimeStep& step_;
  const SparsePrecomputation& precomputation_;
  DenseMatrix scratch_;  // #V by 3
};

}  // namespace mass_spring
