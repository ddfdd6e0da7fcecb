#pragma once

#include <vector>

#include "graph.h"

namespace mass_spring {

/// Eliminate next, as far as can be told cheaply, the vertex with the fewest neighbours left.
/// @param numbering  all vertices; where several have the fewest, their places in it decide
/// @return  which vertex comes first, second, …
std::vector<int> minimum_degree(const Graph& graph, const std::vector<int>& numbering);

}  // namespace mass_spring
