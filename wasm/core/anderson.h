#pragma once

#include <Eigen/Core>

#include "descent.h"
#include "least_squares.h"
#include "steps.h"

namespace mass_spring {

/// Local/global iterations under Anderson acceleration. Yue Peng, Bailin Deng, Juyong Zhang, Fanyu
/// Geng, Wenjie Qin, Ligang Liu, "Anderson acceleration for geometry optimization and physics
/// simulation", 2018.
///
/// With the plain iterate q = p + f, f = -Q⁻¹ ∂E/∂p, and the differences Δf, Δq of the last
/// `window` iterations,
///   θ = argmin |f - Σ_j θ_j Δf_j|,   p ← q - Σ_j θ_j Δq_j,
/// if that lowers E, otherwise p ← q. As Δq = Δp + Δf, this step is a sum of every f and Δp.
template <typename Problem>
class Anderson {
 public:
  using Field = typename Problem::Field;

  void begin(Problem& problem, const Field& p) {
    descent_.begin(problem, p);
    steps_.begin(p);
    q_.resizeLike(p);
  }

  /// @param p  (updated)
  /// @return whether p changed; if not, not even the plain iteration lowers E by more than rounding
  bool iterate(Problem& problem, Field& p) {
    descent_.solve(problem, standing().gradient, steps_.h());
    const int n = steps_.count();
    hh_.col(n).head(n + 1) = steps_.every_h().products(steps_.h());
    hh_.row(n).head(n) = hh_.col(n).head(n).transpose();
    if (n > 0) {
      steps_.every_h_and_s().combine(coefficients(), steps_.s());
      if (move(problem, p)) return true;
    }
    steps_.s() = -steps_.h();
    return move(problem, p);
  }

  const Standing<Field>& standing() const { return descent_.standing(); }

 private:
  static constexpr int window = 5;
  using Numbers = typename Steps<Field, window>::Numbers;

  /// Of every h = -f and s = Δp in the accelerated step.
  Numbers coefficients() const {
    const int n = steps_.count();
    // Newest differences first: of dependent ones the oldest go unused.
    Eigen::Matrix<double, Eigen::Dynamic, 1, 0, window, 1> c(n);
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, window, window> G(n, n);
    for (int i = 0; i < n; ++i) {
      c(i) = hh_(n - i, n) - hh_(n - i - 1, n);
      for (int j = 0; j < n; ++j) {
        G(i, j) = (hh_(n - i, n - j) - hh_(n - i - 1, n - j)) -
                  (hh_(n - i, n - j - 1) - hh_(n - i - 1, n - j - 1));
      }
    }
    const auto theta = least_squares(G, c).reverse().eval();
    Numbers coefficients = Numbers::Zero(2 * n + 1);
    coefficients(n) = -1;
    coefficients.head(n) -= theta;
    coefficients.segment(1, n) += theta;
    coefficients.tail(n) = -theta;
    return coefficients;
  }

  bool move(Problem& problem, Field& p) {
    q_ = p + steps_.s();
    if (!descent_.move(problem, p, q_)) return false;
    if (steps_.count() == window) {
      hh_.template topLeftCorner<window, window>() =
          hh_.template bottomRightCorner<window, window>().eval();
    }
    steps_.advance();
    return true;
  }

  Descent<Problem> descent_;
  Steps<Field, window> steps_;
  Eigen::Matrix<double, window + 1, window + 1> hh_;  // m²: products of every two h
  Field q_;                                           // m: a candidate for the next iterate
};

}  // namespace mass_spring
