#pragma once

#include "types.h"

namespace mass_spring {

/// 1/(2Δt²) Σ m_i |p_i - 2p_i^t + p_i^{t-Δt}|², J: what it costs to leave uniform motion. [L]
/// section 3, [J] "Time integration" (printed there with a minus sign)
/// @param m        #V, kg
/// @param delta_t  s
/// @param p_prev   #V by 3, m: p at t - Δt
/// @param p_curr   #V by 3, m: p at t
/// @param p        #V by 3, m
double inertia(const Vector& m, double delta_t, const Points& p_prev, const Points& p_curr,
               const Points& p);

}  // namespace mass_spring
