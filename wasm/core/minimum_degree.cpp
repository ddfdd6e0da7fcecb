#include "minimum_degree.h"

#include <Eigen/OrderingMethods>

#include "matrix_from_triplets.h"

namespace mass_spring {

std::vector<int> minimum_degree(const Graph& graph) {
  const int n = graph.size();
  Triplets entries;
  for (int i = 0; i < n; ++i) {
    entries.emplace_back(i, i, 1);
    for (const int j : graph.neighbours_of(i)) entries.emplace_back(i, j, 1);
  }
  SparseMatrix pattern;
  matrix_from_triplets(n, n, entries, pattern);
  Eigen::AMDOrdering<int>::PermutationType order(n);
  // Of no vertices Eigen asserts that there are some.
  if (n > 0) Eigen::AMDOrdering<int>()(pattern, order);
  return {order.indices().begin(), order.indices().end()};
}

}  // namespace mass_spring
