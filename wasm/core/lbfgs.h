#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "backtrack.h"
#include "compact_bfgs.h"
#include "descent.h"
#include "linear_span.h"

namespace mass_spring {

/// L-BFGS whose first guess of the inverse Hessian is Q⁻¹ in every iteration. Tiantian Liu, Sofien
/// Bouaziz, Ladislav Kavan, "Quasi-Newton methods for real-time simulation of hyperelastic
/// materials", 2017.
///
/// The first iteration tries the plain one; from then on the last changes of p and ∂E/∂p correct
/// γ Q⁻¹ (compact_bfgs.h), and a line search makes E fall. Since Q overestimates the curvature of
/// E, its inverse is scaled by γ, which the paper does not do; on cloth it spares a quarter of the
/// iterations.
///
/// All that directions are made of is kept as Problem::Direction. That may be in floats: the line
/// search takes E and ∂E/∂p in full, and so does whoever asks how far the minimum is.
template <typename Problem>
class Lbfgs {
 public:
  using Field = typename Problem::Field;

  void begin(Problem& problem, const Field& p) {
    descent_.begin(problem, p);
    q_.resizeLike(p);
    g_.resizeLike(p);
    for (auto* fields : {&h_, &s_}) {
      for (Direction& field : *fields) field.resizeLike(p);
    }
    bfgs_.begin();
  }

  /// @param p  (updated)
  /// @return whether p changed; if not, E cannot be lowered by more than its rounding
  bool iterate(Problem& problem, Field& p) {
    g_ = standing().gradient.template cast<Scalar>();
    descent_.solve(problem, g_, h_[bfgs_.pairs()]);
    if (!bfgs_.arrive(span().products(g_))) forget_pairs();
    if (descend(problem, p)) return true;
    if (bfgs_.pairs() == 0) return false;
    forget_pairs();
    return descend(problem, p);
  }

  const Standing<Field>& standing() const { return descent_.standing(); }

 private:
  using Direction = typename Problem::Direction;
  using Scalar = typename Direction::Scalar;
  using Span = LinearSpan<Direction, 2 * CompactBfgs::window + 1>;

  /// Every h and s in use.
  Span span() const {
    Span span;
    for (int i = 0; i <= bfgs_.pairs(); ++i) span.add(h_[i]);
    for (int i = 0; i < bfgs_.pairs(); ++i) span.add(s_[i]);
    return span;
  }

  /// p ← p - α H ∂E/∂p, if there is an α that lowers E by enough.
  bool descend(Problem& problem, Field& p) {
    const CompactBfgs::Numbers coefficients = -bfgs_.coefficients();
    const double slope = bfgs_.slope(coefficients);
    const double objective = standing().objective;
    const double rounding = std::numeric_limits<double>::epsilon() * std::abs(objective);
    if (!(slope < -rounding)) return false;
    Direction& s = s_[bfgs_.pairs()];
    span().combine(coefficients, s);
    return backtrack(slope, [&](double alpha, double change) {
      q_ = p + alpha * s.template cast<double>();
      if (!descent_.move_below(objective + change, problem, p, q_)) return false;
      if (alpha < 1) s *= static_cast<Scalar>(alpha);
      if (bfgs_.pairs() == CompactBfgs::window) {
        std::rotate(h_.begin(), h_.begin() + 1, h_.end());
        std::rotate(s_.begin(), s_.begin() + 1, s_.end());
      }
      bfgs_.depart(alpha * slope);
      return true;
    });
  }

  void forget_pairs() {
    h_[0].swap(h_[bfgs_.pairs()]);
    bfgs_.forget_pairs();
  }

  Descent<Problem> descent_;
  CompactBfgs bfgs_;
  Direction g_;                                       // N: ∂E/∂p
  std::array<Direction, CompactBfgs::window + 1> h_;  // m: Q⁻¹ ∂E/∂p, of the iterates in use
  std::array<Direction, CompactBfgs::window + 1> s_;  // m: from each of them to the next
  Field q_;                                           // m: a candidate for the next iterate
};

}  // namespace mass_spring
