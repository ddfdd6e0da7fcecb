#pragma once

#include <algorithm>
#include <cmath>

#include "descent.h"
#include "inner_product.h"

namespace mass_spring {

/// Local/global iterations accelerated by the Chebyshev semi-iteration. Huamin Wang, "A Chebyshev
/// semi-iterative approach for accelerating projective and position-based dynamics", 2015.
///
/// After `delay` plain iterations,
///   p^{k+1} = ω_{k+1} (p^k - x^k - p^{k-1}) + p^{k-1},  x = Q⁻¹ ∂E/∂p,  ω_{k+1} = 4/(4 - ρ² ω_k),
/// from ω = 2. The spectral radius ρ of the plain iteration is estimated while it runs, as the
/// ratio of the last two changes |x^k|_Q / |x^{k-1}|_Q with |x|_Q² = xᵀQx = xᵀ ∂E/∂p; in this norm
/// the ratio rises towards ρ and does not overshoot it where E is quadratic. An accelerated iterate
/// that would raise E is replaced by the plain one, and the delay starts again.
template <typename Problem>
class Chebyshev {
 public:
  using Field = typename Problem::Field;

  /// @param delay  S: plain iterations before the acceleration, at least 2
  explicit Chebyshev(int delay = 10) : delay_(delay) {}

  void begin(Problem& problem, const Field& p) {
    descent_.begin(problem, p);
    for (Field* field : {&x_, &q_, &p_before_}) field->resizeLike(p);
    restart();
  }

  /// @param p  (updated)
  /// @return whether p changed; if not, not even the plain iteration lowers E by more than rounding
  bool iterate(Problem& problem, Field& p) {
    descent_.solve(problem, standing().gradient, x_);
    if (plain_ == delay_) {
      omega_ = 4 / (4 - rho_ * rho_ * omega_);
      q_ = omega_ * (p - x_ - p_before_) + p_before_;
      if (move(problem, p)) return true;
      restart();
    }
    const double change = std::sqrt(inner_product(x_, standing().gradient));
    if (plain_ > 0) rho_ = std::min(change / change_before_, greatest_rho);
    change_before_ = change;
    ++plain_;
    q_ = p - x_;
    return move(problem, p);
  }

  const Standing<Field>& standing() const { return descent_.standing(); }

 private:
  // At 1, which a step across a ridge of E suggests, ω would grow to 2 and never forget an error.
  static constexpr double greatest_rho = 0.9999;

  void restart() {
    plain_ = 0;
    omega_ = 2;
  }

  bool move(Problem& problem, Field& p) {
    if (!descent_.move(problem, p, q_)) return false;
    p_before_.swap(q_);
    return true;
  }

  int delay_;
  Descent<Problem> descent_;
  int plain_ = 0;             // plain iterations since the start or the last restart
  double omega_ = 2;          // ω
  double rho_ = 0;            // ρ
  double change_before_ = 0;  // √J: |x^{k-1}|_Q
  Field x_;                   // m: Q⁻¹ ∂E/∂p
  Field q_;                   // m: a candidate for the next iterate
  Field p_before_;            // m: p^{k-1}
};

}  // namespace mass_spring
