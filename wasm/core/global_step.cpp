#include "global_step.h"

#include "right_hand_side.h"

namespace mass_spring {

template <typename Matrix, typename Cholesky>
void global_step(const Precomputation<Matrix, Cholesky>& precomputation, double k, const Points& d,
                 Workspace& workspace, Points& p) {
  right_hand_side(precomputation.A, k, d, workspace);
  // Q p = b
  precomputation.Q.solve(workspace.b, workspace.x, p);
}

template void global_step(const DensePrecomputation&, double, const Points&, Workspace&, Points&);
template void global_step(const SparsePrecomputation&, double, const Points&, Workspace&, Points&);

}  // namespace mass_spring
