#include "fastest_oscillation.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "spring_direction.h"

namespace mass_spring {
namespace {

// The Rayleigh quotient grows to ω² from below, and comes nearer by the square of what the vector
// does.
constexpr int most_iterations = 400;
constexpr double close_enough = 1e-7;  // relative change of ω² in an iteration

/// A spring as it resists small moves: along n with k, across it with a share of that.
struct Linear {
  int i, j;
  Eigen::RowVector3d n;
  double across;  // dimensionless
};

std::vector<Linear> linearised(const TimeStep& step, const Points& q) {
  std::vector<Linear> springs;
  springs.reserve(step.E.rows());
  for (int e = 0; e < step.E.rows(); ++e) {
    const int i = step.E(e, 0), j = step.E(e, 1);
    const double l = (q.row(i) - q.row(j)).norm();
    const double across = step.r(e) == 0 ? 1 : std::max(0.0, 1 - step.r(e) / l);
    springs.push_back({i, j, spring_direction(q.row(i), q.row(j)).transpose(), across});
  }
  return springs;
}

}  // namespace

Oscillation fastest_oscillation(const TimeStep& step, const Points& q) {
  const std::vector<Linear> springs = linearised(step, q);
  const Eigen::VectorXd inverse_m = step.m.cwiseInverse();  // #V, 1/kg
  // In u = M^½ x the matrix is symmetric. Any start will do that no symmetry of the scene shares.
  Points u(step.m.size(), 3);
  for (int c = 0; c < u.size(); ++c) u.data()[c] = std::fmod(0.618034 * (c + 1), 1.0) - 0.5;
  const Eigen::VectorXd scale = inverse_m.cwiseSqrt();
  double squared = 0, resistance = 0;  // ω², 1/s², and 2ζω, 1/s
  for (int iteration = 0; iteration < most_iterations; ++iteration) {
    for (const int i : step.pinned) u.row(i).setZero();
    const double size = u.norm();
    if (size == 0) return {};
    u /= size;
    const Points x = scale.asDiagonal() * u;
    Points force = Points::Zero(u.rows(), 3);
    resistance = 0;
    for (const auto& [i, j, n, across] : springs) {
      const Eigen::RowVector3d move = x.row(i) - x.row(j);
      const double lengthening = move.dot(n);
      const Eigen::RowVector3d resisted = step.k * (across * move + (1 - across) * lengthening * n);
      force.row(i) += resisted;
      force.row(j) -= resisted;
      resistance += step.damping * lengthening * lengthening;
    }
    for (const int i : step.pull.vertices) force.row(i) += step.pull.k * x.row(i);
    const double before = squared;
    squared = force.cwiseProduct(x).sum();
    u = scale.asDiagonal() * force;
    if (std::abs(squared - before) <= close_enough * squared) break;
  }
  const double omega = std::sqrt(squared);
  return {omega, omega > 0 ? resistance / (2 * omega) : 0};
}

}  // namespace mass_spring
