#pragma once

#include "types.h"

namespace mass_spring {

/// The spring term of the quadratic Ẽ(p, d), Σ ½k|(p_i - p_j) - d_ij|², J. Never below
/// potential_energy(p), and equal to it when d is the projection of p. [L] section 4
/// @param E  #E by 2
/// @param k  N/m
/// @param d  #E by 3, m
/// @param p  #V by 3, m
double projection_energy(const Edges& E, double k, const Points& d, const Points& p);

}  // namespace mass_spring
