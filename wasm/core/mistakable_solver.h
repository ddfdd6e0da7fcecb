#pragma once

#include <optional>

#include "solver_parts.h"
#include "sparse_cholesky.h"

namespace mass_spring {

/// Local/global on the plain path, with parts that may be wrong.
class MistakableSolver {
 public:
  /// A, M, C and the factor of Q for this time step and those that differ in forces, targets or
  /// positions only.
  /// @return whether Q is positive definite as far as the arithmetic can tell
  bool precompute(Mistake mistake, const TimeStep& step);

  /// From p^t as far as the numbers stay finite and within reach.
  /// @param step   has to stay where it is
  /// @param V      #V by 3, m: rest positions
  /// @param reach  m: the largest coordinate that does not count as diverged
  void solve(const TimeStep& step, const Points& V, int iterations, double reach);

  void local_step();
  void global_step();
  /// With the order of elimination, as at first.
  bool factorise();
  /// p of the pinned vertices <- where they are held.
  void overwrite_pins();

  bool is_finite() const { return unbounded_vertex_ < 0; }
  /// The first vertex that global_step() put out of reach, or -1.
  int unbounded_vertex() const { return unbounded_vertex_; }
  /// How many times the latest solve() has come to the global step.
  int global_steps() const { return global_steps_; }
  const Points& p() const { return iterate_.p; }

  int factorisation_count() const { return factorisation_count_; }
  double factorisation_time() const { return factorisation_time_; }  // s
  double stored_in_Q() const { return stored_in_Q_; }
  double nonzeros_of_Q() const { return nonzeros_of_Q_; }
  double stored_in_L() const { return Q_ ? Q_->bytes() / (sizeof(double) + sizeof(int)) : 0; }

 private:
  SolverParts parts_ = parts_with(Mistake::none);
  const TimeStep* step_ = nullptr;
  double reach_ = 0;        // m
  SparseMatrix A_, M_, C_;  // #E by #V, #V by #V (kg), #pinned by #V
  Triplets Q_entries_;      // N/m
  std::optional<SparseCholesky> Q_;
  Workspace workspace_;
  Iterate iterate_;
  int unbounded_vertex_ = -1;
  int global_steps_ = 0;
  int factorisation_count_ = 0;
  double factorisation_time_ = 0;  // s
  double stored_in_Q_ = 0;
  double nonzeros_of_Q_ = 0;
};

}  // namespace mass_spring
