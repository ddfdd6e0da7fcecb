#pragma once

#include "types.h"

namespace mass_spring {

/// - Σ p_iᵀ f_i^ext, J: the work the external forces have still to do, counted from the origin. [J]
/// "Time integration"
/// @param f_ext  #V by 3, N
/// @param p      #V by 3, m
double external_energy(const Points& f_ext, const Points& p);

}  // namespace mass_spring
