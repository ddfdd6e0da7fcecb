#pragma once

#include <Eigen/Core>

namespace mass_spring {

/// The inverse Hessian H of L-BFGS, which scalar products suffice for. Richard Byrd, Jorge Nocedal,
/// Robert Schnabel, "Representations of quasi-Newton matrices and their use in limited memory
/// methods", 1994.
///
/// At every iterate let g = ∂E/∂p and h = Q⁻¹g; from one to the next p changes by s, g by y and h
/// by z. With these as columns of S, Y and Z, oldest first, R the upper triangle of SᵀY, D its
/// diagonal, and γ = sᵀy / yᵀz of the latest pair,
///   H g = γ(h - Z a) + S u,   a = R⁻¹ Sᵀg,   u = R⁻ᵀ(D a + γ(YᵀZ a - Zᵀg)).
/// Since Q⁻¹ is symmetric, all of it follows from the products of every s and h with the latest g.
class CompactBfgs {
 public:
  /// How many pairs (s, y) are kept.
  static constexpr int window = 5;
  /// 2 #pairs + 1: one number for each h, from the iterate of the oldest pair to the present one,
  /// then one for each s.
  using Numbers = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 2 * window + 1, 1>;

  void begin() { pairs_ = 0; }

  int pairs() const { return pairs_; }

  /// At a new iterate.
  /// @param products  J: of every h and s with g
  /// @return whether E curves upwards along the latest pair; if not, H would lead uphill
  bool arrive(const Numbers& products);

  /// @return  by which H g combines every h and s
  Numbers coefficients() const;

  /// The product of such a combination with g, J.
  double slope(const Numbers& coefficients) const;

  /// On to the next iterate; of more than `window` pairs the oldest is forgotten.
  /// @param sg  J: product of the new s with g at the iterate that is left
  void depart(double sg);

  void forget_pairs();

 private:
  static constexpr int most_iterates = window + 1;

  int pairs_ = 0;
  Eigen::Matrix<double, most_iterates, 1> hg_;     // J: products of the h with the latest g
  Eigen::Matrix<double, most_iterates, 1> sg_;     // J: of the s
  Eigen::Matrix<double, window, window> R_, YtZ_;  // J: of the pairs there are
};

}  // namespace mass_spring
