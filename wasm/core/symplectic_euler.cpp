#include "symplectic_euler.h"

#include "assemble_forces.h"
#include "velocity_at_start.h"

namespace mass_spring {

void SymplecticEuler::operator()(const TimeStep& step, Points& p) const {
  Points f;  // #V by 3, N
  assemble_forces(step, step.p_curr, velocity_at_start(step), f);
  const Vector mobility = (step.delta_t * step.delta_t) * step.m.cwiseInverse();  // #V, m/N
  p = 2 * step.p_curr - step.p_prev + mobility.asDiagonal() * f;
  for (int c = 0; c < step.pinned.size(); ++c) p.row(step.pinned(c)) = step.targets.row(c);
}

}  // namespace mass_spring
