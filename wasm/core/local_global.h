#pragma once

#include <limits>

#include "descent.h"

namespace mass_spring {

/// The local and the global step read as a method of descent, p ← p - Q⁻¹ ∂E/∂p. In exact
/// arithmetic it makes the same iterates as fast_mass_springs_step. [L] section 4
template <typename Problem>
class LocalGlobal {
 public:
  using Field = typename Problem::Field;

  void begin(Problem& problem, const Field& p) {
    descent_.begin(problem, p);
    q_.resizeLike(p);
  }

  /// @param p  (updated)
  /// @return whether p changed
  bool iterate(Problem& problem, Field& p) {
    descent_.solve(problem, standing().gradient, q_);
    q_ = p - q_;
    // E falls by itself as long as it can; near its minimum its rounding may not tell.
    constexpr double anywhere = std::numeric_limits<double>::infinity();
    return descent_.move_below(anywhere, problem, p, q_) && p != q_;
  }

  const Standing<Field>& standing() const { return descent_.standing(); }

 private:
  Descent<Problem> descent_;
  Field q_;  // m: the next iterate, then the one before
};

}  // namespace mass_spring
