#pragma once

#include <cstdint>
#include <vector>

#include "graph.h"

namespace mass_spring {

/// What the pattern of L looks like, P Q Pᵀ = L Lᵀ, without making it.
struct EliminationTree {
  std::vector<int> parent;  // #columns: row of the first non-zero below the diagonal, or -1
  std::vector<int> height;  // #columns: how many non-zeros lie below the diagonal
  std::int64_t nonzeros;    // of all of L, the diagonal included
};

/// Eliminating a vertex joins all of its neighbours that are still there. [Liu 1990, "The role of
/// elimination trees in sparse factorization"]
/// @param order  which vertex is eliminated first, second, …
EliminationTree elimination_tree(const Graph& graph, const std::vector<int>& order);

}  // namespace mass_spring
