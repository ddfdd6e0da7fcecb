#pragma once

#include "time_step.h"

namespace mass_spring {

/// D = ∂f/∂q̇ as triplets, 3#V by 3#V, N s/m: of the dashpots beside the springs; coordinate c of
/// vertex i is row 3i + c. None without damping.
/// @param q  #V by 3, m
Triplets assemble_damping(const TimeStep& step, const Points& q);

}  // namespace mass_spring
