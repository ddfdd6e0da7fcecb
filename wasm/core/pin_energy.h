#pragma once

#include "types.h"

namespace mass_spring {

/// w/2 Σ |p_i - target_i|² over the vertices that are pinned, or pulled, J. [J] "Pinned vertices"
/// @param pinned   #pinned
/// @param targets  #pinned by 3, m
/// @param w        N/m
/// @param p        #V by 3, m
double pin_energy(const Indices& pinned, const Points& targets, double w, const Points& p);

}  // namespace mass_spring
