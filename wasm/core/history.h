#pragma once

#include <deque>

#include "types.h"

namespace mass_spring {

/// The positions of earlier time steps, the latest on top: what stepping back needs. The oldest are
/// forgotten.
class History {
 public:
  static constexpr int most_steps = 300;
  static constexpr std::size_t most_bytes = 64 << 20;

  /// @param p  #V by 3, m
  void push(Points p);
  /// The positions pushed last for nth = 1, those before for 2, …, size().
  const Points& latest(int nth) const { return steps_[steps_.size() - nth]; }
  void drop_latest(int count) { steps_.resize(steps_.size() - count); }
  void clear() { steps_.clear(); }
  int size() const { return static_cast<int>(steps_.size()); }

 private:
  std::deque<Points> steps_;
};

}  // namespace mass_spring
