#pragma once

#include <Eigen/Core>

namespace mass_spring {

/// Σ a_i · b_i over all rows of two fields of the same shape.
template <typename Field>
double inner_product(const Field& a, const Field& b) {
  // Four sums side by side: a single one would wait for every addition. They add up in the same
  // order whether or not the compiler puts them into vector registers.
  Eigen::Array4d sums = Eigen::Array4d::Zero();
  const Eigen::Index whole = a.size() / 4 * 4;
  for (Eigen::Index i = 0; i < whole; i += 4) {
    for (int lane = 0; lane < 4; ++lane) sums(lane) += a.data()[i + lane] * b.data()[i + lane];
  }
  for (Eigen::Index i = whole; i < a.size(); ++i) sums(i - whole) += a.data()[i] * b.data()[i];
  return (sums(0) + sums(1)) + (sums(2) + sums(3));
}

}  // namespace mass_spring
