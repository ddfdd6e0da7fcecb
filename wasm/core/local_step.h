#pragma once

#include "types.h"

namespace mass_spring {

/// Every spring alone, at its rest length: d_ij = r_ij (p_i - p_j)/|p_i - p_j|, the nearest vector
/// of that length. All directions are equally near to a collapsed spring; it gets +x, whatever the
/// machine. [L] section 4, [J] "Local step"
/// @param E  #E by 2
/// @param r  #E, m
/// @param p  #V by 3, m
/// @param d  #E by 3, m (result): row e points from j to i, |d_e| = r_e
void local_step(const Edges& E, const Vector& r, const Points& p, Points& d);

}  // namespace mass_spring
