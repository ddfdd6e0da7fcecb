#include "global_step.h"

namespace mass_spring {

template <typename Matrix, typename Cholesky>
void global_step(const Precomputation<Matrix, Cholesky>& precomputation, double k, const Points& d,
                 Workspace& workspace, Points& p) {
  // b = k Aᵀ d + y
  workspace.b.resizeLike(workspace.y);
  workspace.b.noalias() = precomputation.A.transpose() * d;
  workspace.b = k * workspace.b + workspace.y;
  // Q p = b
  precomputation.Q.solve(workspace.b, workspace.x, p);
}

template void global_step(const DensePrecomputation&, double, const Points&, Workspace&, Points&);
template void global_step(const SparsePrecomputation&, double, const Points&, Workspace&, Points&);

}  // namespace mass_spring
