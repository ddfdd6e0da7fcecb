#pragma once

#include "parameters.h"
#include "precomputation.h"
#include "time_step.h"

namespace mass_spring {

/// Vertices at 0, 3 and 3 + 4i (m), springs (0, 1) and (2, 1), masses 1, 2 and 4 kg, k = 10 N/m, Δt
/// = 0.5 s, vertex 2 pinned at rest with w = 100 N/m, no external force: numbers small enough to
/// check by hand.
inline TimeStep corner() {
  TimeStep step;
  step.E.resize(2, 2);
  step.E << 0, 1, 2, 1;
  step.r.resize(2);
  step.r << 3, 4;
  step.m.resize(3);
  step.m << 1, 2, 4;
  step.k = 10;
  step.delta_t = 0.5;
  step.w = 100;
  step.pinned.resize(1);
  step.pinned << 2;
  step.targets.resize(1, 3);
  step.targets << 3, 4, 0;
  step.p_curr.resize(3, 3);
  step.p_curr << 0, 0, 0, 3, 0, 0, 3, 4, 0;
  step.p_prev = step.p_curr;
  step.f_ext.setZero(3, 3);
  return step;
}

/// The course's usual numbers.
inline Parameters usual_parameters() {
  Parameters parameters;
  parameters.k = 1e3;
  parameters.delta_t = 1.0 / 30;
  parameters.w = 1e10;
  parameters.iterations = 10;
  parameters.gravity = 9.8;
  return parameters;
}

}  // namespace mass_spring
