#pragma once

#include "precomputation.h"

namespace mass_spring {

/// r, A, M and C of a scene, without the factor of Q.
/// @param V       #V by 3, m: rest positions
/// @param E       #E by 2
/// @param m       #V, kg
/// @param pinned  #pinned
/// @param r       #E, m (result)
/// @param precomputation  its A, M and C (result)
void sparse_matrices(const Points& V, const Edges& E, const Vector& m, const Indices& pinned,
                     Vector& r, SparsePrecomputation& precomputation);

}  // namespace mass_spring
