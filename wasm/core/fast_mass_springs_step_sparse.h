#pragma once

#include "precomputation.h"
#include "time_step.h"

namespace mass_spring {

/// One time step: from p = p^t, alternate the local and the global step. [L] section 4, [J] "Step"
/// @param step  what the time step is given
/// @param precomputation  of fast_mass_springs_precomputation_sparse for the same springs, masses,
/// pins, k, Δt and w
/// @param workspace  leaves y and the last b
/// @param iterate    (result): p is the new p^{t+Δt}
/// @param iterations how many times both half-steps are done
void fast_mass_springs_step_sparse(const TimeStep& step, const SparsePrecomputation& precomputation,
                                   Workspace& workspace, Iterate& iterate, int iterations = 50);

}  // namespace mass_spring
