#pragma once

#include "time_step.h"

namespace mass_spring {

/// c/(2Δt) Σ (nᵀ((p_i - p_j) - (p^t_i - p^t_j)))², J, n the direction of the spring at p^t: what
/// lengthening the dashpots in Δt adds to E(p), so that its derivative is their force at the
/// velocity (p - p^t)/Δt. Quadratic in p, and no more than c/(2Δt) |A (p - p^t)|²: hence c/Δt
/// beside k in Q.
/// @param p  #V by 3, m
double damping_energy(const TimeStep& step, const Points& p);

/// Adds its gradient to g, #V by 3, N.
void add_damping_gradient(const TimeStep& step, const Points& p, Points& g);

/// damping_energy(q) - damping_energy(p), J, from small differences.
double damping_energy_change(const TimeStep& step, const Points& p, const Points& q);

}  // namespace mass_spring
