#pragma once

#include "types.h"

namespace mass_spring {

/// max |g_ic| over the vertices i that are not pinned; 0 if there are none.
/// @param g       #V by 3
/// @param pinned  #pinned
double largest_free_component(const Points& g, const Indices& pinned);

}  // namespace mass_spring
