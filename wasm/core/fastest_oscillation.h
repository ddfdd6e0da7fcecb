#pragma once

#include "time_step.h"

namespace mass_spring {

struct Oscillation {
  double omega = 0;  // ω, rad/s
  double zeta = 0;   // ζ, dimensionless: its dashpots resist with 2ζω times its velocity
};

/// The fastest that springs and pulls allow around q. ω², to one percent, is the largest
/// eigenvalue of M⁻¹(-K), found by iterating with it; where springs push, across which nothing
/// oscillates, K is taken without that part. No springs and no pulls: ω = 0.
/// @param q  #V by 3, m; pinned vertices do not move
Oscillation fastest_oscillation(const TimeStep& step, const Points& q);

}  // namespace mass_spring
