#include "validate_pinned.h"

namespace mass_spring {

Status validate_pinned(const std::vector<int>& pinned, int n) {
  std::vector<int> row_of(n, -1);
  for (std::size_t c = 0; c < pinned.size(); ++c) {
    const int row = static_cast<int>(c), vertex = pinned[c];
    if (vertex < 0 || vertex >= n)
      return {StatusCode::index_out_of_range, "pinned", row, static_cast<double>(vertex)};
    if (row_of[vertex] >= 0)
      return {StatusCode::duplicate_pin, "pinned", row, static_cast<double>(row_of[vertex])};
    row_of[vertex] = row;
  }
  return {};
}

}  // namespace mass_spring
