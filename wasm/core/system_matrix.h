#pragma once

#include "time_step.h"
#include "types.h"

namespace mass_spring {

/// Q = k AᵀA + M/Δt² + w CᵀC as triplets, #V by #V, N/m: what each spring, mass and pin adds to it.
/// It depends neither on positions, forces or time nor on where the pins are held, so one
/// factorisation serves every iteration of every time step. [L] section 4, [J] "Global step"
/// @param E        #E by 2
/// @param k        N/m
/// @param m        #V, kg
/// @param delta_t  s
/// @param pinned   #pinned
/// @param w        N/m
Triplets system_matrix(const Edges& E, double k, const Vector& m, double delta_t,
                       const Indices& pinned, double w);

/// The same of a time step that may have dashpots, which add c/Δt to k, and pulls, which add their
/// stiffness where a pin would add w.
Triplets system_matrix(const TimeStep& step);

}  // namespace mass_spring
