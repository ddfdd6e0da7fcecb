#include "mistakable_solver.h"

#include <chrono>

#include "local_step.h"
#include "mass_matrix.h"
#include "matrix_from_triplets.h"
#include "selection_matrix.h"

namespace mass_spring {

bool MistakableSolver::precompute(Mistake mistake, const TimeStep& step) {
  parts_ = parts_with(mistake);
  const int n = static_cast<int>(step.m.size());
  const Triplets A = parts_.incidence(step.E);
  matrix_from_triplets(static_cast<int>(step.E.rows()), n, A, A_);
  matrix_from_triplets(n, n, mass_matrix(step.m), M_);
  matrix_from_triplets(static_cast<int>(step.pinned.size()), n, selection_matrix(step.pinned), C_);
  Q_entries_ = parts_.system(step, A);
  SparseMatrix Q;
  matrix_from_triplets(n, n, Q_entries_, Q);
  stored_in_Q_ = static_cast<double>(Q.nonZeros());
  nonzeros_of_Q_ = static_cast<double>((Q.coeffs() != 0).count());
  return factorise();
}

bool MistakableSolver::factorise() {
  const auto start = std::chrono::steady_clock::now();
  const bool done = Q_.emplace().factorise(static_cast<int>(M_.rows()), Q_entries_);
  const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
  factorisation_time_ += time.count();
  ++factorisation_count_;
  return done;
}

void MistakableSolver::solve(const TimeStep& step, const Points& V, int iterations, double reach) {
  step_ = &step;
  reach_ = reach;
  unbounded_vertex_ = -1;
  global_steps_ = 0;
  parts_.inertial(step, V, M_, C_, workspace_.y);
  iterate_.p = step.p_curr;
  parts_.iterate(*this, iterations);
}

void MistakableSolver::local_step() {
  mass_spring::local_step(step_->E, step_->r, iterate_.p, iterate_.d);
}

void MistakableSolver::global_step() {
  parts_.right_hand_side(A_, step_->k, iterate_.d, workspace_);
  Q_->solve(workspace_.b, workspace_.x, iterate_.p);
  ++global_steps_;
  for (int i = 0; i < iterate_.p.rows(); ++i) {
    // Written so that not-a-number is found too.
    if (!(iterate_.p.row(i).lpNorm<Eigen::Infinity>() <= reach_)) {
      unbounded_vertex_ = i;
      return;
    }
  }
}

void MistakableSolver::overwrite_pins() {
  for (int c = 0; c < step_->pinned.size(); ++c) {
    iterate_.p.row(step_->pinned(c)) = step_->targets.row(c);
  }
}

}  // namespace mass_spring
