#include "mechanical_energy.h"

#include "T_particle.h"
#include "V_gravity_particle.h"
#include "V_spring_particle_particle.h"

namespace mass_spring {

MechanicalEnergy mechanical_energy(const TimeStep& step, const Points& p, const Points& p_before) {
  MechanicalEnergy energy;
  for (int i = 0; i < p.rows(); ++i) {
    energy.kinetic += T_particle((p.row(i) - p_before.row(i)) / step.delta_t, step.m(i));
    energy.external += V_gravity_particle(p.row(i), step.m(i), step.f_ext.row(i) / step.m(i));
  }
  for (int e = 0; e < step.E.rows(); ++e) {
    energy.springs +=
        V_spring_particle_particle(p.row(step.E(e, 0)), p.row(step.E(e, 1)), step.r(e), step.k);
  }
  return energy;
}

}  // namespace mass_spring
