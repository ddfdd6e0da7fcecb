#pragma once

#include "pair.h"

namespace mass_spring {

/// Σ a_i b_i of n numbers, always summed in the same order.
inline double dot(const double* a, const double* b, int n) {
  Pair sums[2] = {both(0), both(0)};  // two, as an addition takes longer than the next may wait
  int i = 0;
  for (; i + 4 <= n; i += 4) {
    sums[0] += load(a + i) * load(b + i);
    sums[1] += load(a + i + 2) * load(b + i + 2);
  }
  double total = sum(sums[0] + sums[1]);
  for (; i < n; ++i) total += a[i] * b[i];
  return total;
}

}  // namespace mass_spring
