#include "fixed_point_constraints.h"

#include <vector>

namespace mass_spring {

Triplets fixed_point_constraints(int n, const Indices& pinned) {
  std::vector<bool> fixed(n, false);
  for (const int i : pinned) fixed[i] = true;
  Triplets P;
  P.reserve(3 * n);
  int row = 0;
  for (int i = 0; i < n; ++i) {
    if (fixed[i]) continue;
    for (int c = 0; c < 3; ++c) P.emplace_back(row++, 3 * i + c, 1);
  }
  return P;
}

}  // namespace mass_spring
