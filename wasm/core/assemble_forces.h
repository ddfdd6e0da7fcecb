#pragma once

#include "time_step.h"

namespace mass_spring {

/// f(q, q̇), N: of springs, of their dashpots, of pulls, and f^ext. A dashpot resists with c times
/// the speed at which its spring lengthens, along the spring. [V] "Assembling"; dashpots: [P]
/// @param q      #V by 3, m
/// @param q_dot  #V by 3, m/s
/// @param f      #V by 3 (result)
void assemble_forces(const TimeStep& step, const Points& q, const Points& q_dot, Points& f);

}  // namespace mass_spring
