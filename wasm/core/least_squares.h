#pragma once

#include <Eigen/Core>

namespace mass_spring {

/// The θ that minimises |f - Σ_j θ_j a_j|, from scalar products alone: the normal equations G θ = c
/// by Cholesky's method. An a_j that depends on those before it, as far as the products can tell,
/// gets θ_j = 0.
/// @tparam most  how many fields a there may be
/// @param G  #a by #a: G(i, j) = a_i · a_j
/// @param c  #a: c(j) = a_j · f
/// @return   #a: θ
template <int most>
Eigen::Matrix<double, Eigen::Dynamic, 1, 0, most, 1> least_squares(
    const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, most, most>& G,
    const Eigen::Matrix<double, Eigen::Dynamic, 1, 0, most, 1>& c) {
  constexpr double dependent = 1e-10;  // of |a_j|² left after removing those before it
  const int count = static_cast<int>(c.size());
  // G = L D Lᵀ
  auto L = G.eval();
  auto D = c.eval(), theta = c.eval();
  for (int j = 0; j < count; ++j) {
    D(j) = G(j, j);
    for (int l = 0; l < j; ++l) D(j) -= L(j, l) * L(j, l) * D(l);
    if (!(D(j) > dependent * G(j, j))) D(j) = 0;
    for (int i = j + 1; i < count; ++i) {
      for (int l = 0; l < j; ++l) L(i, j) -= L(i, l) * D(l) * L(j, l);
      L(i, j) = D(j) > 0 ? L(i, j) / D(j) : 0;
    }
  }
  // D Lᵀθ = L⁻¹c
  for (int j = 0; j < count; ++j) {
    for (int l = 0; l < j; ++l) theta(j) -= L(j, l) * theta(l);
  }
  for (int j = count - 1; j >= 0; --j) {
    theta(j) = D(j) > 0 ? theta(j) / D(j) : 0;
    for (int i = j + 1; i < count; ++i) theta(j) -= L(i, j) * theta(i);
  }
  return theta;
}

}  // namespace mass_spring
