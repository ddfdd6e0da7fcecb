#pragma once

#include <vector>

#include "types.h"

namespace mass_spring {

/// P Q Pᵀ, where P selects rows and puts them in order.
/// @param Q      entries of a square matrix
/// @param order  which row, and column, comes first, second, …; what is not in it is left out
/// @return #order by #order
SparseMatrix matrix_in_order(const Triplets& Q, const std::vector<int>& order);

}  // namespace mass_spring
