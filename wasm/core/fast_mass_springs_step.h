#pragma once

#include "global_step.h"
#include "inertial_right_hand_side.h"
#include "local_step.h"
#include "precomputation.h"
#include "time_step.h"

namespace mass_spring {

/// One time step in either storage; its two uses are fast_mass_springs_step_dense and _sparse.
template <typename Matrix, typename Cholesky>
void fast_mass_springs_step(const TimeStep& step,
                            const Precomputation<Matrix, Cholesky>& precomputation, int iterations,
                            Workspace& workspace, Iterate& iterate) {
  inertial_right_hand_side(step, precomputation.M, precomputation.C, workspace.y);
  iterate.p = step.p_curr;
  for (int iteration = 0; iteration < iterations; ++iteration) {
    local_step(step.E, step.r, iterate.p, iterate.d);
    iterate.p.swap(iterate.p_before);
    global_step(precomputation, step.k, iterate.d, workspace, iterate.p);
  }
}

}  // namespace mass_spring
