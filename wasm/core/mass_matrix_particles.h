#pragma once

#include "types.h"

namespace mass_spring {

/// M as triplets, 3#V by 3#V, kg: each mass once for each coordinate; coordinate c of vertex i is
/// row 3i + c. [V] "Mass matrix"
/// @param m  #V, kg
Triplets mass_matrix_particles(const Vector& m);

}  // namespace mass_spring
