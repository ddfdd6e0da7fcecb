#pragma once

#include <deque>

#include "types.h"

namespace mass_spring {

/// From where a time step set out.
struct Departure {
  Points p_curr;  // #V by 3, m: p^t
  Points p_prev;  // #V by 3, m: p^{t-Δt}
};

/// From where the earlier time steps set out, the latest on top: what stepping back needs. The
/// oldest are forgotten.
class History {
 public:
  static constexpr int most_steps = 300;
  static constexpr std::size_t most_bytes = 64 << 20;

  void push(Departure departure);
  /// That pushed last for nth = 1, that before for 2, …, size().
  const Departure& latest(int nth) const { return steps_[steps_.size() - nth]; }
  void drop_latest(int count) { steps_.resize(steps_.size() - count); }
  void clear() { steps_.clear(); }
  int size() const { return static_cast<int>(steps_.size()); }

 private:
  std::deque<Departure> steps_;
};

}  // namespace mass_spring
