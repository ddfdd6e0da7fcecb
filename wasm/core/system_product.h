#pragma once

#include "precomputation.h"
#include "time_step.h"

namespace mass_spring {

/// Q p without Q, whose storage the factor may have taken: k Aᵀ(A p) + M p/Δt² + w Cᵀ(C p).
/// @param p   #V by 3, m
/// @param Qp  #V by 3, N (result)
template <typename Matrix, typename Cholesky>
void system_product(const TimeStep& step, const Precomputation<Matrix, Cholesky>& precomputation,
                    const Points& p, Points& Qp);

}  // namespace mass_spring
