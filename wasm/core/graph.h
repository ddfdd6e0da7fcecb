#pragma once

#include <array>
#include <vector>

#include "types.h"

namespace mass_spring {

/// Which vertices are joined, both ways: the pattern of Q off its diagonal.
struct Graph {
  std::vector<int> start{0};    // #vertices + 1: where the neighbours of each begin
  std::vector<int> neighbours;  // vertex after vertex

  int size() const { return static_cast<int>(start.size()) - 1; }

  Eigen::Map<const Indices> neighbours_of(int vertex) const {
    return {neighbours.data() + start[vertex], start[vertex + 1] - start[vertex]};
  }
};

/// @param size   how many vertices there are
/// @param edges  pairs of different vertices, each pair once
Graph graph_from_edges(int size, const std::vector<std::array<int, 2>>& edges);

/// @param Q  symmetric: rows are joined where it has an entry off its diagonal
Graph graph_from_matrix(const SparseMatrix& Q);

}  // namespace mass_spring
