#pragma once

#include "time_step.h"

namespace mass_spring {

/// p^{t+Δt} = p^t + Δt v^t,  v^{t+Δt} = v^t + Δt M⁻¹ f(p^t, v^t): old velocities and old forces.
struct ForwardEuler {
  /// @param p  #V by 3, m (result): pinned vertices where they are held
  void operator()(const TimeStep& step, Points& p) const;
};

/// p^{t+Δt} - Δt v^{t+Δt}, #V by 3, m: what the next time step has to take for its p^{t-Δt}, so
/// that its velocity (p^t - p^{t-Δt})/Δt is v^{t+Δt}. Of pinned vertices, p^t.
Points forward_euler_previous(const TimeStep& step);

}  // namespace mass_spring
