#include "right_parts.h"

#include "inertial_right_hand_side.h"
#include "mistakable_solver.h"
#include "right_hand_side.h"
#include "signed_incidence_matrix.h"

namespace mass_spring {
namespace {

/// Q = k AᵀA + M/Δt² + w CᵀC like system_matrix, but by A's own entries, right or wrong.
Triplets system_of(const TimeStep& step, const Triplets& A) {
  Triplets Q;
  Q.reserve(2 * A.size() + step.m.size() + step.pinned.size());
  // k AᵀA, from the two entries of every row of A
  for (std::size_t e = 0; e < A.size(); e += 2) {
    for (const auto& one : {A[e], A[e + 1]}) {
      for (const auto& other : {A[e], A[e + 1]}) {
        Q.emplace_back(one.col(), other.col(), step.k * one.value() * other.value());
      }
    }
  }
  // M/Δt²
  for (int i = 0; i < step.m.size(); ++i) {
    Q.emplace_back(i, i, step.m(i) / (step.delta_t * step.delta_t));
  }
  // w CᵀC
  for (const int i : step.pinned) Q.emplace_back(i, i, step.w);
  return Q;
}

void inertial(const TimeStep& step, const Points&, const SparseMatrix& M, const SparseMatrix& C,
              Points& y) {
  inertial_right_hand_side(step, M, C, y);
}

void iterate(MistakableSolver& solver, int iterations) {
  for (int iteration = 0; iteration < iterations && solver.is_finite(); ++iteration) {
    solver.local_step();
    solver.global_step();
  }
}

}  // namespace

SolverParts right_parts() {
  return {signed_incidence_matrix, system_of, inertial, right_hand_side<SparseMatrix>, iterate};
}

}  // namespace mass_spring
