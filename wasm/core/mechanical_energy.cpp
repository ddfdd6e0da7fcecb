#include "mechanical_energy.h"

#include "external_energy.h"
#include "potential_energy.h"

namespace mass_spring {

MechanicalEnergy mechanical_energy(const TimeStep& step, const Points& p, const Points& p_before) {
  const Points velocity = (p - p_before) / step.delta_t;  // #V by 3, m/s
  return {
      0.5 * step.m.dot(velocity.rowwise().squaredNorm()),
      potential_energy(step.E, step.k, step.r, p),
      external_energy(step.f_ext, p),
  };
}

}  // namespace mass_spring
