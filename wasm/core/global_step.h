#pragma once

#include "precomputation.h"
#include "time_step.h"

namespace mass_spring {

/// All springs together: the p that minimises the quadratic Ẽ(p, d), Q p = b with b = k Aᵀ d + y.
/// [L] section 4, [J] "Global step"
/// @param precomputation  A and the factor of Q
/// @param k  N/m
/// @param d  #E by 3, m
/// @param workspace  reads y; leaves b
/// @param p  #V by 3, m (result)
template <typename Matrix, typename Cholesky>
void global_step(const Precomputation<Matrix, Cholesky>& precomputation, double k, const Points& d,
                 Workspace& workspace, Points& p);

}  // namespace mass_spring
