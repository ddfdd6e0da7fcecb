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

struct Settings {
  int iterations = 100;   // the most
  double epsilon = 1e-4;  // m
};

/// A place inside the search: after one joint has turned (CCD), after a pass (FABRIK), or after all
/// joints have turned at once (least squares).
template <typename Scalar>
struct Event {
  enum class Kind { joint, backward, forward, all };

  int iteration;  // from 1
  Kind kind;
  int joint;                                       // that has turned, or -1
  std::vector<typename Chain<Scalar>::Vector3> x;  // #joints, m
};

template <typename Scalar>
struct Solution {
  Outcome outcome = Outcome::max_iterations;
  int iterations = 0;
  Pose<Scalar> pose;
  std::vector<Scalar> errors;  // #iterations, m: between effector and target after each
  std::vector<Event<Scalar>> events;
};

}  // namespace kinematics
