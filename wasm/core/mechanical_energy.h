#pragma once

#include "time_step.h"
#include "types.h"

namespace mass_spring {

/// Of masses on springs, in J. A motion without loss keeps the sum.
struct MechanicalEnergy {
  double kinetic = 0;
  double springs = 0;
  double external = 0;  // -Σ p_iᵀ f_i^ext: of gravity, and of wind as if it blew on as now
};

/// T = ½ Σ m_i ‖v_i‖², v = (p - p_before)/Δt, and the potential energies at p.
/// @param p         #V by 3, m
/// @param p_before  #V by 3, m: a time step before
MechanicalEnergy mechanical_energy(const TimeStep& step, const Points& p, const Points& p_before);

}  // namespace mass_spring
