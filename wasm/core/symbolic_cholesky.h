#pragma once

#include <cstdint>
#include <vector>

#include "elimination_order.h"
#include "graph.h"

namespace mass_spring {

/// Neighbouring columns of L with one pattern, stored as a dense panel, its triangle on top.
struct Supernode {
  int first_column;
  int width;           // columns
  int height;          // rows below the last column
  int rows;            // where these begin in SymbolicCholesky::rows
  std::int64_t panel;  // where its (width + height) by width values begin
};

/// The pattern of L, P Q Pᵀ = L Lᵀ: it depends on which vertices springs join, not on the values.
struct SymbolicCholesky {
  std::vector<int> order;                 // P: which vertex comes first, second, …
  std::vector<Supernode> supernodes;      // from left to right
  std::vector<int> rows;                  // supernode after supernode, ascending in each
  std::vector<std::int64_t> edge_values;  // where the panels hold the entry of each edge in Q
  std::int64_t values = 0;                // of all panels: also zeros that keep these simple
  int largest_panel = 0;                  // rows
};

/// @param elimination  of this graph; the order of the result differs where that leaves L the same
/// up to a permutation
SymbolicCholesky symbolic_cholesky(const Graph& graph, const EliminationOrder& elimination);

}  // namespace mass_spring
