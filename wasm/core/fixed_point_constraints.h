#pragma once

#include "types.h"

namespace mass_spring {

/// P as triplets, 3(#V - #pinned) by 3#V: selects the coordinates of the vertices that are free, in
/// their order, so that q = Pᵀ q̂ + q_fixed. [V] "Fixed points"
/// @param n       #V
/// @param pinned  #pinned, in any order
Triplets fixed_point_constraints(int n, const Indices& pinned);

}  // namespace mass_spring
