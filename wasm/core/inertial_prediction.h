#pragma once

#include "time_step.h"

namespace mass_spring {

/// Where inertia and the external forces alone would carry every vertex: 2p^t - p^{t-Δt} + Δt² M⁻¹
/// f^ext.
/// @return #V by 3, m
Points inertial_prediction(const TimeStep& step);

}  // namespace mass_spring
