#include "system.h"

#include "fast_mass_springs_precomputation_dense.h"
#include "fast_mass_springs_precomputation_sparse.h"
#include "fast_mass_springs_step_dense.h"
#include "fast_mass_springs_step_sparse.h"
#include "global_step.h"
#include "inertial_right_hand_side.h"
#include "matrix_from_triplets.h"
#include "selection_matrix.h"
#include "system_product.h"
#include "triplets_from_matrix.h"

namespace mass_spring {

void System::clear(Storage storage) {
  if (storage == Storage::dense) {
    precomputation_.emplace<DensePrecomputation>();
  } else {
    precomputation_.emplace<SparsePrecomputation>();
  }
}

bool System::precompute(const Points& V, const TimeStep& step, Vector& r) {
  if (auto* dense = std::get_if<DensePrecomputation>(&precomputation_)) {
    return fast_mass_springs_precomputation_dense(V, step.E, step.k, step.m, step.pinned,
                                                  step.delta_t, step.w, r, *dense);
  }
  return fast_mass_springs_precomputation_sparse(V, step.E, step.k, step.m, step.pinned,
                                                 step.delta_t, step.w, r,
                                                 std::get<SparsePrecomputation>(precomputation_));
}

void System::reorder_pins(const TimeStep& step) {
  std::visit(
      [&](auto& precomputation) {
        matrix_from_triplets(static_cast<int>(step.pinned.size()), static_cast<int>(step.m.size()),
                             selection_matrix(step.pinned), precomputation.C);
      },
      precomputation_);
}

void System::inertial_right_hand_side(const TimeStep& step, Points& y) const {
  std::visit(
      [&](const auto& precomputation) {
        mass_spring::inertial_right_hand_side(step, precomputation.M, precomputation.C, y);
      },
      precomputation_);
}

void System::global_step(double k, const Points& d, Workspace& workspace, Points& p) const {
  std::visit(
      [&](const auto& precomputation) {
        mass_spring::global_step(precomputation, k, d, workspace, p);
      },
      precomputation_);
}

void System::fast_mass_springs_step(const TimeStep& step, Workspace& workspace, Iterate& iterate,
                                    int iterations) const {
  if (const auto* dense = std::get_if<DensePrecomputation>(&precomputation_)) {
    fast_mass_springs_step_dense(step, *dense, workspace, iterate, iterations);
  } else {
    fast_mass_springs_step_sparse(step, std::get<SparsePrecomputation>(precomputation_), workspace,
                                  iterate, iterations);
  }
}

double System::residual(const TimeStep& step, const Points& p, const Points& b) const {
  Points Qp;  // #V by 3, N
  std::visit([&](const auto& precomputation) { system_product(step, precomputation, p, Qp); },
             precomputation_);
  return (Qp - b).cwiseAbs().maxCoeff();
}

VertexProbe System::probe(const TimeStep& step, const Iterate& iterate, const Points& y,
                          int i) const {
  return std::visit(
      [&](const auto& precomputation) { return vertex_probe(step, precomputation, iterate, y, i); },
      precomputation_);
}

Triplets System::A() const {
  return std::visit([](const auto& matrices) { return triplets_from_matrix(matrices.A); },
                    precomputation_);
}

Triplets System::M() const {
  return std::visit([](const auto& matrices) { return triplets_from_matrix(matrices.M); },
                    precomputation_);
}

Triplets System::C() const {
  return std::visit([](const auto& matrices) { return triplets_from_matrix(matrices.C); },
                    precomputation_);
}

}  // namespace mass_spring
