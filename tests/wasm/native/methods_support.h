#pragma once

#include <doctest/doctest.h>

#include <random>
#include <utility>
#include <vector>

#include "edge_lengths.h"
#include "fast_mass_springs_precomputation_sparse.h"
#include "gravity.h"
#include "newton.h"
#include "stiffness_numbers.h"

namespace mass_spring {

/// A cloth of rows by columns vertices, 1 m apart, of springs along both axes and one
/// diagonal, 1 kg a vertex; its first row is pinned, Δt = 1/30 s, gravity 9.8 m/s².
inline TimeStep cloth(int rows, int columns) {
  const auto vertex = [columns](int row, int column) { return row * columns + column; };
  std::vector<std::pair<int, int>> springs;
  Points V(rows * columns, 3);
  TimeStep step;
  step.pinned.resize(columns);
  step.targets.resize(columns, 3);
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      V.row(vertex(row, column)) << column, 0, row;
      if (column > 0) springs.push_back({vertex(row, column - 1), vertex(row, column)});
      if (row > 0) springs.push_back({vertex(row - 1, column), vertex(row, column)});
      if (row > 0 && column > 0) {
        springs.push_back({vertex(row - 1, column - 1), vertex(row, column)});
      }
    }
  }
  step.E.resize(springs.size(), 2);
  for (int e = 0; e < step.E.rows(); ++e) step.E.row(e) << springs[e].first, springs[e].second;
  for (int column = 0; column < columns; ++column) {
    step.pinned(column) = column;
    step.targets.row(column) = V.row(column);
  }
  edge_lengths(V, step.E, step.r);
  step.m = Vector::Ones(V.rows());
  step.delta_t = 1.0 / 30;
  step.w = 1e10;
  step.p_curr = step.p_prev = V;
  gravity(step.m, 9.8, step.f_ext);
  return step;
}

/// The same in motion: every vertex is off its rest position by up to 0.2 m along each axis, where
/// those pinned are held, and was up to 0.02 m away before.
inline TimeStep crumpled(TimeStep step, unsigned seed) {
  std::mt19937 random(seed);
  const auto up_to = [&random](double most) {
    return most * (random() / (0.5 * std::mt19937::max()) - 1);
  };
  for (double& coordinate : step.p_curr.reshaped()) coordinate += up_to(0.2);
  step.p_prev = step.p_curr;
  for (double& coordinate : step.p_prev.reshaped()) coordinate += up_to(0.02);
  for (int c = 0; c < step.pinned.size(); ++c) {
    step.targets.row(c) = step.p_curr.row(step.pinned(c));
  }
  return step;
}

/// With the k at which κ = max_i Σ_j k Δt²/m_i has the given value.
inline TimeStep with_stiffness_number(TimeStep step, double kappa) {
  step.k = kappa / stiffness_numbers(step.E, 1, step.m, step.delta_t).maxCoeff();
  return step;
}

inline void precompute(const TimeStep& step, SparsePrecomputation& precomputation) {
  Vector r;
  REQUIRE(fast_mass_springs_precomputation_sparse(step.p_curr, step.E, step.k, step.m, step.pinned,
                                                  step.delta_t, step.w, r, precomputation));
}

/// #V by 3, m: where Newton's method ends, which must be within 300 iterations.
inline Points minimiser(const TimeStep& step) {
  Newton newton;
  Points p = step.p_curr;
  newton.begin(step, p);
  int iterations = 0;
  while (newton.iterate(step, p)) REQUIRE(++iterations < 300);
  return p;
}

}  // namespace mass_spring
