#include "objective.h"

#include "damping_energy.h"
#include "external_energy.h"
#include "inertia.h"
#include "pin_energy.h"
#include "potential_energy.h"

namespace mass_spring {

Objective objective(const TimeStep& step, const Points& p) {
  Objective E;
  E.potential = potential_energy(step.E, step.k, step.r, p);
  E.inertia = inertia(step.m, step.delta_t, step.p_prev, step.p_curr, p);
  E.external = external_energy(step.f_ext, p);
  E.pin = pin_energy(step.pinned, step.targets, step.w, p);
  E.damping = damping_energy(step, p);
  E.pull = pin_energy(step.pull.vertices, step.pull.targets, step.pull.k, p);
  E.objective = E.potential + E.inertia + E.external + E.pin + E.damping + E.pull;
  return E;
}

}  // namespace mass_spring
