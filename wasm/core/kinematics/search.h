#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

#include "forward_kinematics.h"
#include "joint_limits.h"
#include "nearest_straight_pose.h"
#include "rotations_from_positions.h"
#include "solution.h"

namespace kinematics {

/// m: the length of the stretched chain.
template <typename Scalar>
Scalar reach(const Chain<Scalar>& chain) {
  Scalar sum = 0;
  for (const auto& offset : chain.offsets) sum += offset.norm();
  return sum;
}

/// Whether all joints lie on the line from the root to the target, on which every method would turn
/// them by nothing or by half a turn.
template <typename Scalar>
bool on_one_line(const Chain<Scalar>& chain, const Pose<Scalar>& pose,
                 const typename Chain<Scalar>::Vector3& target) {
  const auto line = (target - chain.root).normalized().eval();
  return std::all_of(pose.x.begin(), pose.x.end(), [&](const auto& x) {
    const auto aside = (x - chain.root).cross(line).eval();
    return aside.norm() <= Scalar(1e-6) * reach(chain);
  });
}

/// Bends every joint a little, each about an axis across its link.
template <typename Scalar>
void bend(const Chain<Scalar>& chain, Pose<Scalar>& pose) {
  constexpr Scalar angle = Scalar(0.1);  // rad
  for (int i = 0; i + 1 < chain.joints(); ++i) {
    const auto axis = chain.offsets[i].unitOrthogonal();
    pose.q[i] = pose.q[i] * Eigen::AngleAxis<Scalar>(i % 2 == 0 ? angle : -2 * angle, axis);
  }
  forward_kinematics(chain, 0, pose);
}

/// What all methods have in common: when a search ends, and how.
/// @param start    whose q are read; FK has been run
/// @param limits   hold at the start and wherever this turns a joint; `iterate` holds by itself
/// @param iterate  (pose, iteration, events): one iteration
template <typename Scalar, typename Iterate>
Solution<Scalar> search(const Chain<Scalar>& chain, const Pose<Scalar>& start,
                        const typename Chain<Scalar>::Vector3& target, const Settings& settings,
                        const JointLimits<Scalar>& limits, Iterate iterate) {
  Solution<Scalar> solution;
  Pose<Scalar>& pose = solution.pose;
  pose = start;
  if (limits.any()) limits.hold(pose);
  solution.start = pose;
  using Kind = typename Event<Scalar>::Kind;
  const auto error = [&] { return (pose.effector() - target).norm(); };
  const auto straight = nearest_straight_pose(chain, target);
  const auto ended = [&](Outcome otherwise) {
    solution.outcome = error() <= settings.epsilon ? Outcome::converged  // also of just too far
                       : straight                  ? Outcome::unreachable
                                                   : otherwise;
    return solution;
  };
  if (straight && !limits.bending()) {
    rotations_from_positions(chain, *straight, pose);
    if (limits.any()) limits.hold(pose);  // it comes nearer every time it is looked for
    solution.events.push_back({0, Kind::straight, -1, pose.x, pose.q});
    return ended(Outcome::unreachable);
  }
  // Of the largest coordinate that a joint can have: what rounding moves it by.
  const Scalar resolution =
      4 * std::numeric_limits<Scalar>::epsilon() * (chain.root.norm() + reach(chain));
  bool bent = false;
  while (error() > settings.epsilon) {
    if (solution.iterations == settings.iterations) return ended(Outcome::max_iterations);
    if (!bent && on_one_line(chain, pose, target)) {
      bend(chain, pose);
      if (limits.any()) limits.hold(pose);
      solution.events.push_back({solution.iterations, Kind::bend, -1, pose.x, pose.q});
      bent = true;
    }
    const std::vector<typename Chain<Scalar>::Vector3> before = pose.x;
    ++solution.iterations;
    iterate(pose, solution.iterations, solution.events);
    solution.errors.push_back(error());
    Scalar moved = 0;
    for (int i = 0; i < chain.joints(); ++i) {
      moved = std::max(moved, (pose.x[i] - before[i]).norm());
    }
    if (moved <= resolution && error() > settings.epsilon) return ended(Outcome::stalled);
  }
  return ended(Outcome::converged);
}

}  // namespace kinematics
