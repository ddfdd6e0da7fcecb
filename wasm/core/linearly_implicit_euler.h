#pragma once

#include <Eigen/SparseCholesky>

#include "spring_blocks.h"
#include "time_step.h"
#include "types.h"

namespace mass_spring {

/// (M - Δt D - Δt² K) q̇^{t+Δt} = M q̇^t + Δt f(q^t),  q^{t+Δt} = q^t + Δt q̇^{t+Δt}
/// with K = ∂f/∂q and D = ∂f/∂q̇ at q^t, the pinned vertices taken out by P: one step of Newton's
/// method for E(p) from p^t, without its line search. The pattern of P(…)Pᵀ is analysed once for
/// the same springs and pins; every step fills in its values and factorises. [V] "Linearly implicit
/// time integration"
class LinearlyImplicitEuler {
 public:
  /// @param q  #V by 3, m (result): pinned vertices where they are held; not-a-numbers where the
  /// matrix cannot be factorised
  void operator()(const TimeStep& step, Points& q);

  /// P(M - Δt D - Δt² K)Pᵀ of the last step, #unknowns by #unknowns, kg.
  const SparseMatrix& matrix() const { return blocks_.matrix(); }

 private:
  void fill_in(const TimeStep& step, const Points& q_dot);

  SpringBlocks blocks_;
  Vector b_;  // #unknowns, N s
  Eigen::SimplicialLDLT<SparseMatrix> ldlt_;
};

}  // namespace mass_spring
