#include "linearly_implicit_euler.h"

#include <algorithm>
#include <limits>

#include "assemble_forces.h"
#include "assemble_stiffness.h"
#include "d2V_spring_particle_particle_dq2.h"
#include "fixed_point_constraints.h"
#include "mass_matrix_particles.h"
#include "matrix_from_triplets.h"
#include "same_set.h"
#include "spring_direction.h"
#include "velocity_at_start.h"

namespace mass_spring {

void LinearlyImplicitEuler::operator()(const TimeStep& step, Points& q) {
  const int n = static_cast<int>(step.m.size());
  if (unknown_.size() != step.m.size() || edges_.rows() != step.E.rows() || edges_ != step.E ||
      !same_set(pinned_, step.pinned)) {
    analyse(step);
  }

  Points q_dot = Points::Zero(n, 3);  // #V by 3, m/s: of the pinned vertices, as they are moved
  for (int c = 0; c < step.pinned.size(); ++c) {
    const int i = step.pinned(c);
    q_dot.row(i) = (step.targets.row(c) - step.p_curr.row(i)) / step.delta_t;
  }
  fill_in(step, q_dot);

  Vector x(matrix_.rows());
  ldlt_.factorize(matrix_);
  if (ldlt_.info() == Eigen::Success) {
    x = ldlt_.solve(b_);
  } else {
    x.setConstant(std::numeric_limits<double>::quiet_NaN());
  }
  for (int i = 0; i < n; ++i) {
    if (unknown_(i) >= 0) q_dot.row(i) = x.segment<3>(unknown_(i));
  }
  q = step.p_curr + step.delta_t * q_dot;
  for (int c = 0; c < step.pinned.size(); ++c) q.row(step.pinned(c)) = step.targets.row(c);
}

/// The pattern of P(M - Δt D - Δt² K)Pᵀ, and where each spring's share of it goes.
void LinearlyImplicitEuler::analyse(const TimeStep& step) {
  const int n = static_cast<int>(step.m.size());
  edges_ = step.E;
  pinned_ = step.pinned;
  SparseMatrix M, K, P;
  matrix_from_triplets(3 * n, 3 * n, mass_matrix_particles(step.m), M);
  matrix_from_triplets(3 * n, 3 * n, assemble_stiffness(step, step.p_curr), K);
  const Triplets selected = fixed_point_constraints(n, step.pinned);
  matrix_from_triplets(static_cast<int>(selected.size()), 3 * n, selected, P);
  matrix_ = P * SparseMatrix(M - K) * P.transpose();
  ldlt_.analyzePattern(matrix_);

  unknown_.setConstant(n, -1);
  for (const auto& entry : selected) {
    if (entry.col() % 3 == 0) unknown_(entry.col() / 3) = entry.row();
  }
  places_.clear();
  for (int e = 0; e < step.E.rows(); ++e) {
    const int i = unknown_(step.E(e, 0)), j = unknown_(step.E(e, 1));
    places_.push_back({place_of(i, i), place_of(j, j), place_of(i, j), place_of(j, i)});
  }
}

LinearlyImplicitEuler::Place LinearlyImplicitEuler::place_of(int row, int column) const {
  if (row < 0 || column < 0) return nowhere;
  Place place;
  for (int c = 0; c < 3; ++c) {
    const int* rows = matrix_.innerIndexPtr();
    const int* const end = rows + matrix_.outerIndexPtr()[column + c + 1];
    const int* const found = std::lower_bound(rows + matrix_.outerIndexPtr()[column + c], end, row);
    place[c] = static_cast<int>(found - rows);
  }
  return place;
}

void LinearlyImplicitEuler::add(const Place& place, const Eigen::Matrix3d& block) {
  if (place == nowhere) return;
  for (int c = 0; c < 3; ++c) {
    Eigen::Map<Eigen::Vector3d>(matrix_.valuePtr() + place[c]) += block.col(c);
  }
}

/// Matrix and right-hand side, P(M q̇^t + Δt f) less what the matrix makes of the pinned vertices.
/// @param q_dot  #V by 3, m/s: of the pinned vertices, 0 elsewhere
void LinearlyImplicitEuler::fill_in(const TimeStep& step, const Points& q_dot) {
  const double delta_t = step.delta_t;
  Points f;  // #V by 3, N; the dashpots resist the new velocities, by the matrix
  assemble_forces(step, step.p_curr, Points::Zero(step.m.size(), 3), f);
  Points b = step.m.asDiagonal() * velocity_at_start(step) + delta_t * f;  // #V by 3, N s

  std::fill_n(matrix_.valuePtr(), matrix_.nonZeros(), 0.0);
  for (int e = 0; e < step.E.rows(); ++e) {
    const int i = step.E(e, 0), j = step.E(e, 1);
    const auto d2V =
        d2V_spring_particle_particle_dq2(step.p_curr.row(i), step.p_curr.row(j), step.r(e), step.k);
    Eigen::Matrix3d block = delta_t * delta_t * d2V.topLeftCorner<3, 3>();  // kg
    if (step.damping > 0) {
      const Eigen::Vector3d n = spring_direction(step.p_curr.row(i), step.p_curr.row(j));
      block += delta_t * step.damping * n * n.transpose();
    }
    const auto& [ii, jj, ij, ji] = places_[e];
    add(ii, block);
    add(jj, block);
    add(ij, -block);
    add(ji, -block);
    b.row(i) += q_dot.row(j) * block;
    b.row(j) += q_dot.row(i) * block;
  }
  Vector diagonal = step.m;  // #V, kg
  for (const int i : step.pull.vertices) diagonal(i) += delta_t * delta_t * step.pull.k;

  b_.resize(matrix_.rows());
  for (int i = 0; i < unknown_.size(); ++i) {
    if (unknown_(i) < 0) continue;
    b_.segment<3>(unknown_(i)) = b.row(i);
    for (int c = 0; c < 3; ++c) {
      const int row = unknown_(i) + c;
      matrix_.coeffRef(row, row) += diagonal(i);
    }
  }
}

}  // namespace mass_spring
