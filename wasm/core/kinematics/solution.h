#pragma once

#include <string>
#include <vector>

#include "chain.h"

namespace kinematics {

/// How a search for a pose ended: the end effector is within ε of the target; nothing moves any
/// more; no pose reaches the target, and this is the nearest; or all iterations are made.
enum class Outcome { converged, stalled, unreachable, max_iterations };

/// The spelling of every Outcome, in order.
const std::vector<std::string>& outcome_names();

/// rad: no rotation turns further.
constexpr double no_limit = 3.14159265358979323846;

struct Settings {
  int iterations = 100;          // the most
  double epsilon = 1e-4;         // m
  double turn_limit = no_limit;  // rad: of every joint, between the start and the end of a search
  std::vector<double> bend_limits;  // #links, rad: of the link at joint i from where it points at
                                    // rest as joint i - 1 sees it; none: no joint has a limit
};

/// A place inside the search: after one joint has turned (CCD), after a pass (FABRIK), after all
/// joints have turned at once (least squares), after FABRIK's rotations were held to limits, after
/// a stretched chain was bent a little so that there is a direction to turn in, or after the chain
/// was laid straight towards what it cannot reach.
template <typename Scalar>
struct Event {
  enum class Kind { joint, backward, forward, all, limit, straight, bend };

  int iteration;  // from 1; 0: before the first
  Kind kind;
  int joint;                                         // that has turned, or -1
  std::vector<typename Chain<Scalar>::Vector3> x;    // #joints, m
  std::vector<typename Pose<Scalar>::Quaternion> q;  // #joints; of a backward pass as before it
};

template <typename Scalar>
struct Solution {
  Outcome outcome = Outcome::max_iterations;
  int iterations = 0;
  Pose<Scalar> start;  // held to its limits
  Pose<Scalar> pose;
  std::vector<Scalar> errors;  // #iterations, m: between effector and target after each
  std::vector<Event<Scalar>> events;
};

}  // namespace kinematics
