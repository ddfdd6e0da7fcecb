#pragma once

#include "time_step.h"

namespace mass_spring {

/// v^{t+Δt} = v^t + Δt M⁻¹ f(p^t, v^t),  p^{t+Δt} = p^t + Δt v^{t+Δt}: old forces, new velocities.
/// As a descent of E(p) it is the step p^t - (M/Δt²)⁻¹ ∂E/∂p. Without dashpots stable only while
/// Δt ω < 2 for every frequency ω of the springs.
struct SymplecticEuler {
  /// @param p  #V by 3, m (result): pinned vertices where they are held
  void operator()(const TimeStep& step, Points& p) const;
};

}  // namespace mass_spring
