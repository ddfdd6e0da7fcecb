#include "validate_vertices.h"

namespace mass_spring {

Status validate_vertices(const std::string& field, const std::vector<int>& vertices, int n) {
  std::vector<int> row_of(n, -1);
  for (std::size_t c = 0; c < vertices.size(); ++c) {
    const int row = static_cast<int>(c), vertex = vertices[c];
    if (vertex < 0 || vertex >= n)
      return {StatusCode::index_out_of_range, field, row, static_cast<double>(vertex)};
    if (row_of[vertex] >= 0)
      return {StatusCode::duplicate_vertex, field, row, static_cast<double>(row_of[vertex])};
    row_of[vertex] = row;
  }
  return {};
}

}  // namespace mass_spring
