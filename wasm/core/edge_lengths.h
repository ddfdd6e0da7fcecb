#pragma once

#include "types.h"

namespace mass_spring {

/// The length of every spring; of the rest positions, the rest lengths r.
/// @param p       #V by 3, m
/// @param E       #E by 2
/// @param lengths #E, m (result)
void edge_lengths(const Points& p, const Edges& E, Vector& lengths);

}  // namespace mass_spring
