#pragma once

#include "time_step.h"

namespace mass_spring {

/// v^t = (p^t - p^{t-Δt})/Δt, #V by 3, m/s: of every method but forward Euler the change of the
/// last time step; what that one makes, forward_euler_previous() puts in the place of p^{t-Δt}.
inline Points velocity_at_start(const TimeStep& step) {
  return (step.p_curr - step.p_prev) / step.delta_t;
}

}  // namespace mass_spring
