#pragma once

#include <random>
#include <set>
#include <utility>

#include "edge_lengths.h"
#include "time_step.h"

namespace mass_spring {

/// Rest positions and a time step of a scene in motion.
struct TestScene {
  Points V;  // #V by 3, m
  TimeStep step;
};

/// Coordinates between -1 and 1, the same ones whatever the compiler.
inline Points random_points(int rows, unsigned seed) {
  std::mt19937 random(seed);
  Points p(rows, 3);
  for (double& x : p.reshaped<Eigen::RowMajor>()) x = random() / 2147483648.0 - 1;
  return p;
}

/// Completes V and E: k of the given stiffness number, vertices displaced by some centimetres and
/// moving, pins dragged off their places. The penalty is so stiff that pins drift by rounding only.
inline void set_in_motion(const std::vector<int>& pinned, double stiffness_number, unsigned seed,
                          TestScene& scene) {
  const int n = static_cast<int>(scene.V.rows());
  TimeStep& step = scene.step;
  edge_lengths(scene.V, step.E, step.r);
  step.m = (1.5 + 0.5 * random_points(n, seed + 1).col(0).array()) * 0.01;
  step.delta_t = 1.0 / 30;
  const double springs_each = std::max(1.0, 2.0 * static_cast<double>(step.E.rows()) / n);
  step.k = stiffness_number * 0.01 / (springs_each * step.delta_t * step.delta_t);
  step.w = 1e18;
  step.pinned = Eigen::Map<const Indices>(pinned.data(), static_cast<int>(pinned.size()));
  step.p_prev = scene.V + 0.03 * random_points(n, seed + 2);
  step.p_curr = scene.V + 0.03 * random_points(n, seed + 3);
  step.targets =
      scene.V(pinned, Eigen::all) + 0.03 * random_points(static_cast<int>(pinned.size()), seed + 4);
  step.f_ext.setZero(n, 3);
  step.f_ext.col(1) = -9.8 * step.m;
}

/// Vertices anywhere in a cube of 2 m, springs between any two; perhaps in several pieces, perhaps
/// with vertices that no spring holds. The first vertices are pinned.
inline TestScene random_scene(int vertices, int springs, int pins, unsigned seed) {
  TestScene scene;
  scene.V = random_points(vertices, seed);
  std::mt19937 random(seed);
  std::set<std::pair<int, int>> joined;
  scene.step.E.resize(springs, 2);
  while (static_cast<int>(joined.size()) < springs) {
    const int i = static_cast<int>(random() % vertices), j = static_cast<int>(random() % vertices);
    if (i == j || !joined.insert(std::minmax(i, j)).second) continue;
    scene.step.E.row(joined.size() - 1) << i, j;
  }
  std::vector<int> pinned(pins);
  for (int c = 0; c < pins; ++c) pinned[c] = c;
  set_in_motion(pinned, 100, seed, scene);
  return scene;
}

/// A flag of columns by rows vertices, 5 cm apart, with one diagonal in every square; its first
/// column is pinned.
inline TestScene flag(int columns, int rows, double stiffness_number) {
  TestScene scene;
  scene.V.resize(columns * rows, 3);
  std::vector<int> E, pinned;
  for (int x = 0; x < columns; ++x) {
    for (int y = 0; y < rows; ++y) {
      const int i = x * rows + y;
      scene.V.row(i) << 0.05 * x, 0.05 * y, 0;
      if (x == 0) pinned.push_back(i);
      if (y + 1 < rows) E.insert(E.end(), {i, i + 1});
      if (x + 1 < columns) E.insert(E.end(), {i, i + rows});
      if (x + 1 < columns && y + 1 < rows) E.insert(E.end(), {i, i + rows + 1});
    }
  }
  scene.step.E = Eigen::Map<const Edges>(E.data(), E.size() / 2, 2);
  set_in_motion(pinned, stiffness_number, 7, scene);
  return scene;
}

}  // namespace mass_spring
