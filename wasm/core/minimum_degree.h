#pragma once

#include <vector>

#include "graph.h"

namespace mass_spring {

/// Eliminate next, as far as can be told cheaply, the vertex with the fewest neighbours left.
/// @return which vertex comes first, second, …
std::vector<int> minimum_degree(const Graph& graph);

}  // namespace mass_spring
