#pragma once

#include <vector>

#include "elimination_tree.h"

namespace mass_spring {

/// Columns of L that are stored and treated together, as if all had the pattern of the last.
struct ColumnGroup {
  std::vector<int> columns;   // ascending
  int height = 0;             // how many rows with non-zeros lie below the last column
  std::vector<int> children;  // groups whose first row below is one of these columns
};

/// Groups of columns with nearly the same pattern: the zeros stored cost less than what is saved by
/// reading indices once a group. [Ashcraft and Grimes 1989, "The influence of relaxed supernode
/// partitions on the multifrontal method"]
/// @return children before parents, each group right after its descendants
std::vector<ColumnGroup> column_groups(const EliminationTree& tree);

}  // namespace mass_spring
