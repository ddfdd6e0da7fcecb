#pragma once

#include "spring_blocks.h"
#include "time_step.h"

namespace mass_spring {

/// H = ∂²E/∂p², N/m: a spring of length l along the unit vector n adds
/// ±k [n nᵀ + (1 - r/l)(I - n nᵀ)] to the 3 by 3 blocks of its ends, a mass m/Δt², a pin w and a
/// pull its stiffness to the diagonal; a dashpot c/Δt n nᵀ like its spring, with the n of p^t.
///
/// Across a spring shorter than r, which pushes, E curves downwards: 1 - r/l is negative, and
/// infinite if the spring has collapsed. Without that share H is positive definite.
/// @param p         #V by 3, m
/// @param left_out  share of that negative curvature to leave out: 0 is the exact Hessian, with 1
/// it is certain to be positive definite
/// @param H         analysed for the springs of the step, without the vertices that do not move
/// (result)
void hessian(const TimeStep& step, const Points& p, double left_out, SpringBlocks& H);

}  // namespace mass_spring
