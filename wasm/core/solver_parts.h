#pragma once

#include "mistake.h"
#include "time_step.h"

namespace mass_spring {

class MistakableSolver;

/// The places where a local/global solver can go wrong.
struct SolverParts {
  /// A, #E by #V
  Triplets (*incidence)(const Edges& E);
  /// Q, #V by #V, N/m
  Triplets (*system)(const TimeStep& step, const Triplets& A);
  /// y, #V by 3, N, V being the rest positions
  void (*inertial)(const TimeStep& step, const Points& V, const SparseMatrix& M,
                   const SparseMatrix& C, Points& y);
  /// b, #V by 3, N
  void (*right_hand_side)(const SparseMatrix& A, double k, const Points& d, Workspace& workspace);
  /// From p^t to p^{t+Δt}
  void (*iterate)(MistakableSolver& solver, int iterations);
};

/// The right parts, but for what the mistake puts in the place of one of them; where pins are
/// imposed after solving, of three.
SolverParts parts_with(Mistake mistake);

}  // namespace mass_spring
