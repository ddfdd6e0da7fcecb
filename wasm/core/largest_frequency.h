#pragma once

#include "time_step.h"

namespace mass_spring {

/// ω of the fastest oscillation of springs and pulls around q, rad/s, to half a percent: ω² is
/// the largest eigenvalue of M⁻¹(-K), found by iterating with it. Where springs push, across which
/// nothing oscillates, K is taken without that part.
/// @param q  #V by 3, m; pinned vertices do not move
double largest_frequency(const TimeStep& step, const Points& q);

}  // namespace mass_spring
