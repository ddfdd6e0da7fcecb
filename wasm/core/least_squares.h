#pragma once

#include <array>
#include <cmath>

#include "inner_product.h"

namespace mass_spring {

/// The θ that minimises |f - Σ_j θ_j a_j|, by modified Gram-Schmidt on [a f]: as accurate as
/// Householder's QR, where the normal equations would square the condition number.
/// @param count  how many of the fields a there are; the other θ are 0. An a_j that depends on
/// those before it, up to rounding, gets θ_j = 0 as well
/// @param a  fields of one shape; left orthonormal
/// @param f  field of the same shape; left as the residual
template <typename Field, std::size_t most>
std::array<double, most> least_squares(int count, std::array<Field, most>& a, Field& f) {
  constexpr double dependent = 1e-10;  // of a field's length left after removing those before it
  std::array<double, most> length, theta{};
  for (int j = 0; j < count; ++j) length[j] = std::sqrt(inner_product(a[j], a[j]));

  // a = (orthonormal) R, θ ← (orthonormal)ᵀ f
  Eigen::Matrix<double, most, most> R = Eigen::Matrix<double, most, most>::Identity();
  for (int j = 0; j < count; ++j) {
    const double left = std::sqrt(inner_product(a[j], a[j]));
    if (left <= dependent * length[j]) {
      a[j].setZero();
      continue;
    }
    R(j, j) = left;
    a[j] /= left;
    for (int l = j + 1; l < count; ++l) {
      R(j, l) = inner_product(a[j], a[l]);
      a[l] -= R(j, l) * a[j];
    }
    theta[j] = inner_product(a[j], f);
    f -= theta[j] * a[j];
  }

  // R θ = θ
  for (int j = count - 1; j >= 0; --j) {
    for (int l = j + 1; l < count; ++l) theta[j] -= R(j, l) * theta[l];
    theta[j] /= R(j, j);
  }
  return theta;
}

}  // namespace mass_spring
