#pragma once

#include "types.h"

namespace mass_spring {

/// Elastic energy Σ ½k(|p_i - p_j| - r_ij)², J. [L] section 3, [J] "Spring energy"
/// @param E  #E by 2
/// @param k  N/m
/// @param r  #E, m
/// @param p  #V by 3, m
double potential_energy(const Edges& E, double k, const Vector& r, const Points& p);

}  // namespace mass_spring
