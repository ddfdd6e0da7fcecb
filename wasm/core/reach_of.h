#pragma once

#include "types.h"

namespace mass_spring {

/// m: no coordinate of a motion that has not exploded comes this far: a million times the largest
/// of the rest positions, or of 1 m. What explodes gets there in some dozen time steps.
/// @param V  #V by 3, m: rest positions
double reach_of(const Points& V);

}  // namespace mass_spring
