#include "fast_mass_springs_step_sparse.h"

#include "fast_mass_springs_step.h"

namespace mass_spring {

void fast_mass_springs_step_sparse(const TimeStep& step, const SparsePrecomputation& precomputation,
                                   Workspace& workspace, Iterate& iterate, int iterations) {
  fast_mass_springs_step(step, precomputation, iterations, workspace, iterate);
}

}  // namespace mass_spring
