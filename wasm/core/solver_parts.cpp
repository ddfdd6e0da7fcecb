#include "solver_parts.h"

#include "matrix_from_triplets.h"
#include "mistakable_solver.h"
#include "right_parts.h"

namespace mass_spring {
namespace {

void project_once(MistakableSolver& solver, int iterations) {
  solver.local_step();
  for (int iteration = 0; iteration < iterations && solver.is_finite(); ++iteration) {
    solver.global_step();
  }
}

void right_hand_side_without_k(const SparseMatrix& A, double, const Points& d,
                               Workspace& workspace) {
  workspace.b.resizeLike(workspace.y);
  workspace.b.noalias() = A.transpose() * d;
  workspace.b = workspace.b + workspace.y;
}

Triplets incidence_without_minus(const Edges& E) {
  Triplets A;
  A.reserve(2 * E.rows());
  for (int e = 0; e < E.rows(); ++e) {
    A.emplace_back(e, E(e, 0), 1.0);
    A.emplace_back(e, E(e, 1), 1.0);
  }
  return A;
}

void inertial_with_times_swapped(const TimeStep& step, const Points&, const SparseMatrix& M,
                                 const SparseMatrix& C, Points& y) {
  const Points inertial =
      (2 * step.p_prev - step.p_curr) / (step.delta_t * step.delta_t);  // #V by 3, m/s²
  const Points held = step.w * step.targets;                            // #pinned by 3, N
  y = step.f_ext;
  y.noalias() += M * inertial;
  y.noalias() += C.transpose() * held;
}

void inertial_with_rest_for_targets(const TimeStep& step, const Points& V, const SparseMatrix& M,
                                    const SparseMatrix& C, Points& y) {
  const Points inertial =
      (2 * step.p_curr - step.p_prev) / (step.delta_t * step.delta_t);  // #V by 3, m/s²
  const Points held = step.w * V;                                       // #V by 3, N
  y = step.f_ext;
  y.noalias() += M * inertial;
  y.noalias() += C.transpose() * C * held;
}

void inertial_with_gradient_as_force(const TimeStep& step, const Points&, const SparseMatrix& M,
                                     const SparseMatrix& C, Points& y) {
  const Points inertial =
      (2 * step.p_curr - step.p_prev) / (step.delta_t * step.delta_t);  // #V by 3, m/s²
  const Points held = step.w * step.targets;                            // #pinned by 3, N
  y = -step.f_ext;  // the gradient of - Σ p_iᵀ f_i^ext
  y.noalias() += M * inertial;
  y.noalias() += C.transpose() * held;
}

Triplets system_without_pins(const TimeStep& step, const Triplets& A) {
  TimeStep free = step;
  free.pinned.resize(0);
  return right_parts().system(free, A);
}

void inertial_without_pins(const TimeStep& step, const Points&, const SparseMatrix& M,
                           const SparseMatrix&, Points& y) {
  const Points inertial =
      (2 * step.p_curr - step.p_prev) / (step.delta_t * step.delta_t);  // #V by 3, m/s²
  y = step.f_ext;
  y.noalias() += M * inertial;
}

void overwrite_pins_after_solving(MistakableSolver& solver, int iterations) {
  for (int iteration = 0; iteration < iterations && solver.is_finite(); ++iteration) {
    solver.local_step();
    solver.global_step();
    solver.overwrite_pins();
  }
}

void factorise_every_iteration(MistakableSolver& solver, int iterations) {
  for (int iteration = 0; iteration < iterations && solver.is_finite(); ++iteration) {
    solver.local_step();
    solver.factorise();
    solver.global_step();
  }
}

Triplets system_with_zeros(const TimeStep& step, const Triplets& A) {
  const int n = static_cast<int>(step.m.size());
  DenseMatrix Q;
  matrix_from_triplets(n, n, right_parts().system(step, A), Q);
  Triplets entries;
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) entries.emplace_back(i, j, Q(i, j));
  }
  return entries;
}

void iterate_once(MistakableSolver& solver, int) {
  solver.local_step();
  solver.global_step();
}

}  // namespace

SolverParts parts_with(Mistake mistake) {
  SolverParts parts = right_parts();
  switch (mistake) {
    case Mistake::none:
      break;
    case Mistake::d_once:
      parts.iterate = project_once;
      break;
    case Mistake::k_forgotten:
      parts.right_hand_side = right_hand_side_without_k;
      break;
    case Mistake::sign_in_A:
      parts.incidence = incidence_without_minus;
      break;
    case Mistake::times_swapped:
      parts.inertial = inertial_with_times_swapped;
      break;
    case Mistake::rest_for_targets:
      parts.inertial = inertial_with_rest_for_targets;
      break;
    case Mistake::pins_after_solving:
      parts.system = system_without_pins;
      parts.inertial = inertial_without_pins;
      parts.iterate = overwrite_pins_after_solving;
      break;
    case Mistake::factorised_again:
      parts.iterate = factorise_every_iteration;
      break;
    case Mistake::gradient_as_force:
      parts.inertial = inertial_with_gradient_as_force;
      break;
    case Mistake::stored_zeros:
      parts.system = system_with_zeros;
      break;
    case Mistake::one_iteration:
      parts.iterate = iterate_once;
      break;
  }
  return parts;
}

}  // namespace mass_spring
