#pragma once

#include "precomputation.h"
#include "types.h"

namespace mass_spring {

/// Rest lengths, matrices and the Cholesky factor of Q, dense. To be called again when k, Δt, w,
/// the masses or the set of pinned vertices change. [J] "Precomputation"
/// @param V        #V by 3, m: rest positions
/// @param E        #E by 2
/// @param k        N/m
/// @param m        #V, kg
/// @param pinned   #pinned
/// @param delta_t  s
/// @param w        N/m
/// @param r        #E, m (result)
/// @param precomputation  (result)
/// @return whether Q is positive definite as far as the arithmetic can tell
bool fast_mass_springs_precomputation_dense(const Points& V, const Edges& E, double k,
                                            const Vector& m, const Indices& pinned, double delta_t,
                                            double w, Vector& r,
                                            DensePrecomputation& precomputation);

}  // namespace mass_spring
