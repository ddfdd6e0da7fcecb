#pragma once

#include "time_step.h"

namespace mass_spring {

/// Where the forces at p^t would carry the vertices, instead of those at the unknown p^{t+Δt}:
///   p^{t+Δt} = 2p^t - p^{t-Δt} + Δt² M⁻¹ (f(p^t) + f^ext),
/// with the velocity (p^t - p^{t-Δt})/Δt this is symplectic Euler. Stable only while Δt ω < 2 for
/// every frequency ω of the springs.
/// @return  #V by 3, m; pinned vertices where they are held
Points explicit_step(const TimeStep& step);

}  // namespace mass_spring
