#pragma once

#include "standing.h"

namespace mass_spring {

/// What the methods that minimise E(p) with the factor of Q have in common: a standing, and moves
/// from p that lower E. None of them allocates after begin. They run over any class with
///
///   using Field = …;                                     // positions and forces, one vertex a row
///   double objective_and_gradient(const Field& p, Field& g);  // E(p), J, and g = ∂E/∂p, N
///   void apply_inverse(const Field& g, Field& x);             // x = Q⁻¹ g, m
///
///   using Direction = …;                                      // forces and changes of positions,
///   void apply_inverse(const Direction& g, Direction& x);     // perhaps in fewer digits
template <typename Problem>
class Descent {
 public:
  using Field = typename Problem::Field;

  void begin(Problem& problem, const Field& p) {
    standing_.gradient.resizeLike(p);
    gradient_before_.resizeLike(p);
    standing_.objective = problem.objective_and_gradient(p, standing_.gradient);
    standing_.gradient_evaluations = 1;
    standing_.solves = 0;
  }

  /// x = Q⁻¹ g, m; for g = ∂E/∂p, one iteration of local and global step is p ← p - x.
  /// @tparam Any  Field or Problem::Direction
  template <typename Any>
  void solve(Problem& problem, const Any& g, Any& x) {
    problem.apply_inverse(g, x);
    ++standing_.solves;
  }

  /// Swaps p and q if E(q) lies below `bound`, J; otherwise leaves everything as it is.
  bool move_below(double bound, Problem& problem, Field& p, Field& q) {
    const double objective = problem.objective_and_gradient(q, gradient_before_);
    ++standing_.gradient_evaluations;
    if (!(objective < bound)) return false;  // not-a-number is not below either
    standing_.objective = objective;
    standing_.gradient.swap(gradient_before_);
    p.swap(q);
    return true;
  }

  /// Swaps p and q if that lowers E.
  bool move(Problem& problem, Field& p, Field& q) {
    return move_below(standing_.objective, problem, p, q);
  }

  const Standing<Field>& standing() const { return standing_; }
  /// After a successful move, ∂E/∂p before it, N.
  const Field& gradient_before() const { return gradient_before_; }

 private:
  Standing<Field> standing_;
  Field gradient_before_;
};

}  // namespace mass_spring
