#include "factor_pattern.h"

namespace mass_spring {

FactorPattern factor_pattern(const Graph& graph, const EliminationTree& tree) {
  const int n = graph.size();
  FactorPattern pattern;
  pattern.start.assign(n + 1, 0);
  for (int column = 0; column < n; ++column) {
    pattern.start[column + 1] = pattern.start[column] + 1 + tree.height[column];
  }
  pattern.rows.resize(pattern.start[n]);
  std::vector<int> end(pattern.start.begin(), pattern.start.end() - 1);  // of those entered so far
  std::vector<int> visited(n, -1);  // the last row in which a column was found non-zero
  for (int row = 0; row < n; ++row) {
    visited[row] = row;
    pattern.rows[end[row]++] = row;
    for (const int neighbour : graph.neighbours_of(row)) {
      for (int column = neighbour; column < row && visited[column] != row;
           column = tree.parent[column]) {
        visited[column] = row;
        pattern.rows[end[column]++] = row;
      }
    }
  }
  return pattern;
}

}  // namespace mass_spring
