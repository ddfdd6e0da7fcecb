#pragma once

#include <vector>

#include "elimination_tree.h"
#include "graph.h"

namespace mass_spring {

/// Where L, P Q Pᵀ = L Lᵀ, may have non-zeros.
struct FactorPattern {
  std::vector<int> start{0};  // #columns + 1: where the rows of each column begin
  std::vector<int> rows;      // column after column, ascending in each: the diagonal comes first

  int size() const { return static_cast<int>(start.size()) - 1; }
};

/// Row of L by row of L: the columns on the ways up the tree from the row's entries in Q. [Davis
/// 2006, "Direct Methods for Sparse Linear Systems", section 4.2]
/// @param graph  of P Q Pᵀ: vertices in the order of elimination
/// @param tree   of the same
FactorPattern factor_pattern(const Graph& graph, const EliminationTree& tree);

}  // namespace mass_spring
