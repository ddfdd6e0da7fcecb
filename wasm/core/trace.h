#pragma once

#include <vector>

#include "time_step.h"

namespace mass_spring {

/// A place inside a time step of K iterations: half_step 0 is predict, 2k-1 local(k), 2k global(k)
/// for k = 1…K, 2K+1 accept.
struct Cursor {
  int half_step = 0;
  Iterate iterate;
  /// #V by 3, m: at accept, what the next time step takes for its p^{t-Δt}.
  Points next_p_prev;

  bool at_global() const { return half_step > 0 && half_step % 2 == 0; }
};

/// The half-steps of one time step that were gone through so far: a row of numbers each, and enough
/// iterates to return to any of them.
class Trace {
 public:
  /// half_step, objective, surrogate, potential, inertia, external, pin (J), gradient, residual
  /// (N), change (m)
  static constexpr int columns = 10;

  /// Appends the row of the next half-step, recorded().
  /// @param residual    max |Qp - b|, N; not a number where the half-step does not solve Q p = b
  /// @param iterations  K
  void append(const TimeStep& step, const Cursor& cursor, double residual, int iterations);

  /// `half_step` itself if it is recorded and the iterates around it are kept; otherwise a place
  /// before it from which to go there.
  Cursor start_for(int half_step, const TimeStep& step) const;

  /// The half-steps 0 … recorded() - 1 have rows.
  int recorded() const { return static_cast<int>(rows_.size()) / columns; }
  /// recorded() by columns, row-major.
  const std::vector<double>& rows() const { return rows_; }

 private:
  std::vector<double> rows_;
  int stride_ = 1;                // how many iterations lie between two kept iterates
  std::vector<Points> iterates_;  // after iterations 0, stride_, 2 stride_, …: #V by 3 each, m
};

}  // namespace mass_spring
