#pragma once

#include "types.h"

namespace mass_spring {

/// C as triplets, #pinned by #V: one +1 a row, so that C p are the pinned rows of p. [J] "Pinned
/// vertices"
/// @param pinned  #pinned, indices of vertices
Triplets selection_matrix(const Indices& pinned);

}  // namespace mass_spring
