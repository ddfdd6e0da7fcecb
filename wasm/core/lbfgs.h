#pragma once

#include <cmath>
#include <limits>

#include "backtrack.h"
#include "compact_bfgs.h"
#include "descent.h"
#include "steps.h"

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
    steps_.begin(p);
    bfgs_.begin();
    g_.resizeLike(p);
    q_.resizeLike(p);
  }

  /// @param p  (updated)
  /// @return whether p changed; if not, E cannot be lowered by more than its rounding
  bool iterate(Problem& problem, Field& p) {
    g_ = standing().gradient.template cast<Scalar>();
    descent_.solve(problem, g_, steps_.h());
    if (!bfgs_.arrive(steps_.every_h_and_s().products(g_))) forget_pairs();
    if (descend(problem, p)) return true;
    if (bfgs_.pairs() == 0) return false;
    forget_pairs();
    return descend(problem, p);
  }

  const Standing<Field>& standing() const { return descent_.standing(); }

 private:
  using Direction = typename Problem::Direction;
  using Scalar = typename Direction::Scalar;

  /// p ← p - α H ∂E/∂p, if there is an α that lowers E by enough.
  bool descend(Problem& problem, Field& p) {
    const CompactBfgs::Numbers coefficients = -bfgs_.coefficients();
    const double slope = bfgs_.slope(coefficients);
    const double objective = standing().objective;
    const double rounding = std::numeric_limits<double>::epsilon() * std::abs(objective);
    if (!(slope < -rounding)) return false;
    steps_.every_h_and_s().combine(coefficients, steps_.s());
    return backtrack(slope, [&](double alpha, double change) {
      q_ = p + alpha * steps_.s().template cast<double>();
      if (!descent_.move_below(objective + change, problem, p, q_)) return false;
      if (alpha < 1) steps_.s() *= static_cast<Scalar>(alpha);
      steps_.advance();
      bfgs_.depart(alpha * slope);
      return true;
    });
  }

  void forget_pairs() {
    steps_.forget();
    bfgs_.forget_pairs();
  }

  Descent<Problem> descent_;
  Steps<Direction, CompactBfgs::window> steps_;
  CompactBfgs bfgs_;  // of steps_
  Direction g_;       // N: ∂E/∂p
  Field q_;           // m: a candidate for the next iterate
};

}  // namespace mass_spring
