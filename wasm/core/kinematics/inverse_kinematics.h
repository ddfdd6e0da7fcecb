#pragma once

#include <string>
#include <vector>

#include "solution.h"
#include "status.h"

namespace kinematics {

enum class Method { ccd, fabrik, least_squares };

/// The spelling of every Method, in order.
const std::vector<std::string>& method_names();

/// A search as it comes in, unchecked.
struct Task {
  std::vector<double> offsets;  // #links by 3, m, row-major: from each joint to the next at rest
  std::vector<double> root;     // 3, m
  std::vector<double> start;    // #joints by 3, m, of which only the directions count; or
  std::vector<double> start_q;  // #joints by 4, (x, y, z, w), of any length but 0; neither: at rest
  std::vector<double> target;   // 3, m
  Method method = Method::ccd;
  Settings settings;
  bool single_precision = false;
};

/// What came of it, in doubles whatever the precision.
struct Answer {
  Outcome outcome = Outcome::max_iterations;
  int iterations = 0;
  double error = 0;             // m
  std::vector<double> start_x;  // #joints by 3, m: where the search began
  std::vector<double> start_q;  // #joints by 4
  std::vector<double> x;        // #joints by 3, m
  std::vector<double> q;        // #joints by 4, (x, y, z, w): of each joint against the one before
  std::vector<double> errors;   // #iterations, m
  std::vector<int> events;      // #events by 3: iteration, Event::Kind, joint or -1
  std::vector<double> event_x;  // #events by #joints by 3, m
  std::vector<double> event_q;  // #events by #joints by 4
};

/// By any method and precision.
/// @return not ok, with the answer as it was: a link without length, a target on the root, whose
/// direction is none, a number that is not finite, a negative limit, a list of the wrong
/// length, or a start both by positions and by rotations
mass_spring::Status inverse_kinematics(const Task& task, Answer& answer);

}  // namespace kinematics
