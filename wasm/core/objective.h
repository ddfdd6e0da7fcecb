#pragma once

#include "time_step.h"

namespace mass_spring {

/// E(p) and its terms, J.
struct Objective {
  double objective;
  double potential;
  double inertia;
  double external;
  double pin;
  double damping;
  double pull;
};

/// E(p), what both half-steps of a time step lower. [L] section 3, [J] "Time integration"
/// @param p  #V by 3, m
Objective objective(const TimeStep& step, const Points& p);

}  // namespace mass_spring
