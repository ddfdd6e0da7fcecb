#include "graph.h"

#include <numeric>

namespace mass_spring {

Graph graph_from_edges(int size, const std::vector<std::array<int, 2>>& edges) {
  Graph graph;
  graph.start.assign(size + 1, 0);
  for (const auto& [i, j] : edges) {
    ++graph.start[i + 1];
    ++graph.start[j + 1];
  }
  std::partial_sum(graph.start.begin(), graph.start.end(), graph.start.begin());
  std::vector<int> end(graph.start.begin(), graph.start.end() - 1);  // of those entered so far
  graph.neighbours.resize(2 * edges.size());
  for (const auto& [i, j] : edges) {
    graph.neighbours[end[i]++] = j;
    graph.neighbours[end[j]++] = i;
  }
  return graph;
}

Graph graph_from_matrix(const SparseMatrix& Q) {
  std::vector<std::array<int, 2>> edges;
  for (int j = 0; j < Q.outerSize(); ++j) {
    for (SparseMatrix::InnerIterator entry(Q, j); entry; ++entry) {
      if (entry.row() > j) edges.push_back({static_cast<int>(entry.row()), j});
    }
  }
  return graph_from_edges(static_cast<int>(Q.rows()), edges);
}

}  // namespace mass_spring
