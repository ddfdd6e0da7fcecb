#pragma once

#include <vector>

#include "elimination_tree.h"
#include "graph.h"
#include "types.h"

namespace mass_spring {

struct EliminationOrder {
  std::vector<int> order;  // which vertex comes first, second, …
  EliminationTree tree;    // of that order
};

/// Of the minimum degree and the nested dissection order, the one of which L has fewer non-zeros:
/// for most cloths the former, for large solid blocks the latter.
/// @param V      #vertices by 3, m
/// @param graph  of these vertices
EliminationOrder elimination_order(const Points& V, const Graph& graph);

}  // namespace mass_spring
