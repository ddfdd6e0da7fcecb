#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "backtrack.h"
#include "descent.h"
#include "inner_product.h"

namespace mass_spring {

/// L-BFGS whose first guess of the inverse Hessian is Q⁻¹ in every iteration. Tiantian Liu, Sofien
/// Bouaziz, Ladislav Kavan, "Quasi-Newton methods for real-time simulation of hyperelastic
/// materials", 2017.
///
/// The last `window` changes s = p^{k+1} - p^k and y = ∂E/∂p^{k+1} - ∂E/∂p^k correct γ Q⁻¹ by the
/// two-loop recursion; a line search makes E fall. The first iteration tries the plain one. Since Q
/// overestimates the curvature of E, its inverse is scaled by γ = sᵀy / yᵀQ⁻¹y of the latest pair,
/// which the paper does not do; on cloth it spares a quarter of the iterations.
template <typename Problem>
class Lbfgs {
 public:
  using Field = typename Problem::Field;

  void begin(Problem& problem, const Field& p) {
    descent_.begin(problem, p);
    for (Field* field : {&h_, &h_before_, &rest_, &x_, &q_}) field->resizeLike(p);
    for (auto* fields : {&s_, &y_, &z_}) {
      for (Field& field : *fields) field.resizeLike(p);
    }
    pairs_ = 0;
    moved_ = false;
  }

  /// @param p  (updated)
  /// @return whether p changed; if not, E cannot be lowered by more than its rounding
  bool iterate(Problem& problem, Field& p) {
    h_.swap(h_before_);
    descent_.solve(problem, standing().gradient, h_);
    if (moved_) remember(p, q_);
    find_direction();
    const double objective = standing().objective;
    const double slope = -inner_product(x_, standing().gradient);
    const double rounding = std::numeric_limits<double>::epsilon() * std::abs(objective);
    const auto falls = [&](double alpha, double change) {
      q_ = p - alpha * x_;
      return descent_.move_below(objective + change, problem, p, q_);
    };
    moved_ = slope < -rounding && backtrack(slope, falls);
    return moved_;
  }

  const Standing<Field>& standing() const { return descent_.standing(); }

 private:
  static constexpr int window = 5;

  /// Keeps the pair of the move from p_before to p, if E curves upwards along it; one that does not
  /// would lead uphill.
  void remember(const Field& p, const Field& p_before) {
    const int i = pairs_ % window;
    s_[i] = p - p_before;
    y_[i] = standing().gradient - descent_.gradient_before();
    z_[i] = h_ - h_before_;
    sy_[i] = inner_product(s_[i], y_[i]);
    if (sy_[i] > 0) ++pairs_;
  }

  /// x = H ∂E/∂p, H being γ Q⁻¹ corrected by the pairs (s, y); the step is -α x.
  void find_direction() {
    const int oldest = std::max(0, pairs_ - window);
    std::array<double, window> a;
    rest_ = standing().gradient;
    x_ = h_;  // Q⁻¹ rest, throughout the first loop
    for (int k = pairs_ - 1; k >= oldest; --k) {
      const int i = k % window;
      a[i] = inner_product(s_[i], rest_) / sy_[i];
      rest_ -= a[i] * y_[i];
      x_ -= a[i] * z_[i];
    }
    if (pairs_ > 0) {
      const int latest = (pairs_ - 1) % window;
      x_ *= sy_[latest] / inner_product(y_[latest], z_[latest]);  // γ
    }
    for (int k = oldest; k < pairs_; ++k) {
      const int i = k % window;
      const double b = inner_product(y_[i], x_) / sy_[i];
      x_ += (a[i] - b) * s_[i];
    }
  }

  Descent<Problem> descent_;
  int pairs_ = 0;                        // kept since the start; the last `window` are in the rings
  bool moved_ = false;                   // in the last iteration, from q to p
  std::array<Field, window> s_, y_, z_;  // m, N, m: rings of changes of p, ∂E/∂p and Q⁻¹ ∂E/∂p
  std::array<double, window> sy_;        // J: sᵀy
  Field h_, h_before_;                   // m: Q⁻¹ ∂E/∂p here and at the iterate before
  Field rest_;                           // N: what the pairs leave of ∂E/∂p for Q⁻¹
  Field x_;                              // m: H ∂E/∂p
  Field q_;                              // m: a candidate for the next iterate, then the one before
};

}  // namespace mass_spring
