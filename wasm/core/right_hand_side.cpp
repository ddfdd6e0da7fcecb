#include "right_hand_side.h"

namespace mass_spring {

template <typename Matrix>
void right_hand_side(const Matrix& A, double k, const Points& d, Workspace& workspace) {
  workspace.b.resizeLike(workspace.y);
  workspace.b.noalias() = A.transpose() * d;
  workspace.b = k * workspace.b + workspace.y;
}

template void right_hand_side(const DenseMatrix&, double, const Points&, Workspace&);
template void right_hand_side(const SparseMatrix&, double, const Points&, Workspace&);

}  // namespace mass_spring
