#pragma once

#include "types.h"

namespace mass_spring {

/// M as triplets, #V by #V: the masses on the diagonal, kg.
/// @param m  #V, kg
Triplets mass_matrix(const Vector& m);

}  // namespace mass_spring
