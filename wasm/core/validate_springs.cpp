#include "validate_springs.h"

#include <algorithm>
#include <array>

namespace mass_spring {

Status validate_springs(const std::vector<int>& E, int n) {
  if (E.size() % 2 != 0) return {StatusCode::wrong_length, "E", -1, static_cast<double>(E.size())};
  const int springs = static_cast<int>(E.size() / 2);
  std::vector<std::array<int, 3>> ends(springs);  // lower vertex, higher vertex, row
  for (int e = 0; e < springs; ++e) {
    const int i = E[2 * e], j = E[2 * e + 1];
    for (const int vertex : {i, j}) {
      if (vertex < 0 || vertex >= n)
        return {StatusCode::index_out_of_range, "E", e, static_cast<double>(vertex)};
    }
    if (i == j) return {StatusCode::self_spring, "E", e, static_cast<double>(i)};
    ends[e] = {std::min(i, j), std::max(i, j), e};
  }
  std::sort(ends.begin(), ends.end());
  for (int s = 1; s < springs; ++s) {
    if (ends[s][0] == ends[s - 1][0] && ends[s][1] == ends[s - 1][1]) {
      return {StatusCode::duplicate_spring, "E", ends[s][2], static_cast<double>(ends[s - 1][2])};
    }
  }
  return {};
}

}  // namespace mass_spring
