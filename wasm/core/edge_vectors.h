#pragma once

#include "types.h"

namespace mass_spring {

/// A p, spring by spring: row e is p_i - p_j for spring e = (i, j), pointing from j to i.
/// @param E  #E by 2
/// @param p  #V by 3, m
/// @param x  #E by 3, m (result)
void edge_vectors(const Edges& E, const Points& p, Points& x);

}  // namespace mass_spring
