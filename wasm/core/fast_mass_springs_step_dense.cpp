#include "fast_mass_springs_step_dense.h"

#include "fast_mass_springs_step.h"

namespace mass_spring {

void fast_mass_springs_step_dense(const TimeStep& step, const DensePrecomputation& precomputation,
                                  Workspace& workspace, Iterate& iterate, int iterations) {
  fast_mass_springs_step(step, precomputation, iterations, workspace, iterate);
}

}  // namespace mass_spring
