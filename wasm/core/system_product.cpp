#include "system_product.h"

#include "edge_vectors.h"

namespace mass_spring {

template <typename Matrix, typename Cholesky>
void system_product(const TimeStep& step, const Precomputation<Matrix, Cholesky>& precomputation,
                    const Points& p, Points& Qp) {
  Points Ap;  // #E by 3, m
  edge_vectors(step.E, p, Ap);
  const Points springs = step.k * Ap;                          // #E by 3, N
  const Points inertial = p / (step.delta_t * step.delta_t);   // #V by 3, m/s²
  const Points held = step.w * (precomputation.C * p).eval();  // #pinned by 3, N
  Qp.setZero(p.rows(), 3);
  Qp.noalias() += precomputation.A.transpose() * springs;
  Qp.noalias() += precomputation.M * inertial;
  Qp.noalias() += precomputation.C.transpose() * held;
}

template void system_product(const TimeStep&, const DensePrecomputation&, const Points&, Points&);
template void system_product(const TimeStep&, const SparsePrecomputation&, const Points&, Points&);

}  // namespace mass_spring
