#pragma once

#include "types.h"

namespace mass_spring {

/// κ_i = Σ_j k Δt²/m_i over the springs of vertex i, dimensionless: how far its springs outweigh
/// its inertia in Q. The largest bounds the digits that solving with Q costs.
/// @param E        #E by 2
/// @param k        N/m
/// @param m        #V, kg
/// @param delta_t  s
/// @return #V
Vector stiffness_numbers(const Edges& E, double k, const Vector& m, double delta_t);

}  // namespace mass_spring
