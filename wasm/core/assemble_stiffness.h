#pragma once

#include "time_step.h"

namespace mass_spring {

/// K = ∂f/∂q as triplets, 3#V by 3#V, N/m: of springs and pulls, the negative Hessian of their
/// energy; coordinate c of vertex i is row 3i + c. Which entries there are depends on E and the
/// vertices that are pulled only. [V] "Linearly implicit time integration"
/// @param q  #V by 3, m
Triplets assemble_stiffness(const TimeStep& step, const Points& q);

}  // namespace mass_spring
