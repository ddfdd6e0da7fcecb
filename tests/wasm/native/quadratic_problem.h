#pragma once

#include "types.h"

namespace mass_spring {

/// E = ½ Σ h_i |p_i|² with Q the identity: what the methods do to it is known. Its positions have a
/// fourth column of zeros, as SIMD lanes like them.
struct QuadraticProblem {
  using Field = Eigen::Matrix<double, Eigen::Dynamic, 4, Eigen::RowMajor>;
  using Direction = Field;

  Vector h;  // #n, N/m, each at most 1

  double objective_and_gradient(const Field& p, Field& g) const {
    g.noalias() = h.asDiagonal() * p;
    return 0.5 * (p.array() * g.array()).sum();
  }
  void apply_inverse(const Field& g, Field& x) const { x = g; }
};

}  // namespace mass_spring
