#include "elimination_tree.h"

#include <numeric>

#include "inverse_permutation.h"

namespace mass_spring {

EliminationTree elimination_tree(const Graph& graph, const std::vector<int>& order) {
  const int n = graph.size();
  const std::vector<int> place = inverse_permutation(order);
  EliminationTree tree;
  tree.parent.assign(n, -1);
  tree.height.assign(n, 0);
  std::vector<int> visited(n, -1);  // the last row in which a column was found non-zero
  for (int row = 0; row < n; ++row) {
    visited[row] = row;
    // Row of L: the columns on the ways up the tree from the row's entries in Q.
    for (const int neighbour : graph.neighbours_of(order[row])) {
      for (int column = place[neighbour]; column < row && visited[column] != row;
           column = tree.parent[column]) {
        if (tree.parent[column] < 0) tree.parent[column] = row;
        ++tree.height[column];
        visited[column] = row;
      }
    }
  }
  tree.nonzeros = std::accumulate(tree.height.begin(), tree.height.end(), std::int64_t{n});
  return tree;
}

}  // namespace mass_spring
