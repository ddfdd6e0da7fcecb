#include "inertial_right_hand_side.h"

namespace mass_spring {

template <typename Matrix>
void inertial_right_hand_side(const TimeStep& step, const Matrix& M, const Matrix& C, Points& y) {
  const Points inertial =
      (2 * step.p_curr - step.p_prev) / (step.delta_t * step.delta_t);  // #V by 3, m/s²
  const Points held = step.w * step.targets;                            // #pinned by 3, N
  y = step.f_ext;
  y.noalias() += M * inertial;
  y.noalias() += C.transpose() * held;
}

template void inertial_right_hand_side(const TimeStep&, const DenseMatrix&, const DenseMatrix&,
                                       Points&);
template void inertial_right_hand_side(const TimeStep&, const SparseMatrix&, const SparseMatrix&,
                                       Points&);

}  // namespace mass_spring
