#pragma once

#include "types.h"

namespace mass_spring {

/// A as triplets, #E by #V: for spring e = (i, j), +1 in column i and -1 in column j, so that (A
/// p)_e = p_i - p_j.
/// @param E  #E by 2
Triplets signed_incidence_matrix(const Edges& E);

}  // namespace mass_spring
