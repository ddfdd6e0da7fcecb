#include "minimum_degree.h"

#include <Eigen/OrderingMethods>

#include "inverse_permutation.h"
#include "matrix_from_triplets.h"

namespace mass_spring {

std::vector<int> minimum_degree(const Graph& graph, const std::vector<int>& numbering) {
  const int n = graph.size();
  const std::vector<int> place = inverse_permutation(numbering);
  Triplets entries;
  for (int i = 0; i < n; ++i) {
    entries.emplace_back(place[i], place[i], 1);
    for (const int j : graph.neighbours_of(i)) entries.emplace_back(place[i], place[j], 1);
  }
  SparseMatrix pattern;
  matrix_from_triplets(n, n, entries, pattern);
  Eigen::AMDOrdering<int>::PermutationType order(n);
  // Of no vertices Eigen asserts that there are some.
  if (n > 0) Eigen::AMDOrdering<int>()(pattern, order);
  std::vector<int> vertices;
  for (const int number : order.indices()) vertices.push_back(numbering[number]);
  return vertices;
}

}  // namespace mass_spring
