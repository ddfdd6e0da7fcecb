#include "forward_euler.h"

#include "assemble_forces.h"
#include "velocity_at_start.h"

namespace mass_spring {

void ForwardEuler::operator()(const TimeStep& step, Points& p) const {
  p = step.p_curr + (step.p_curr - step.p_prev);
  for (int c = 0; c < step.pinned.size(); ++c) p.row(step.pinned(c)) = step.targets.row(c);
}

// p^t + Δt v^t - Δt (v^t + Δt M⁻¹ f) = p^t - Δt² M⁻¹ f
Points forward_euler_previous(const TimeStep& step) {
  Points f;  // #V by 3, N
  assemble_forces(step, step.p_curr, velocity_at_start(step), f);
  const Vector mobility = (step.delta_t * step.delta_t) * step.m.cwiseInverse();  // #V, m/N
  Points p = step.p_curr - mobility.asDiagonal() * f;
  for (const int i : step.pinned) p.row(i) = step.p_curr.row(i);
  return p;
}

}  // namespace mass_spring
