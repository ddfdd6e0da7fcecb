#include "inverse_permutation.h"

namespace mass_spring {

std::vector<int> inverse_permutation(const std::vector<int>& order) {
  const int n = static_cast<int>(order.size());
  std::vector<int> place(n);
  for (int i = 0; i < n; ++i) place[order[i]] = i;
  return place;
}

}  // namespace mass_spring
