#pragma once

#include <string>

#include "parameters.h"
#include "time_step.h"

namespace mass_spring {

/// All that the trace of a time step is a function of.
struct State {
  Points V;        // #V by 3, m: rest positions
  Vector scene_m;  // #V, kg: before mass_scale
  Parameters parameters;
  int step_number = 1;
  TimeStep time_step;  // its k, Δt, w, m and f_ext are for derive() to fill in

  /// The first time step from rest, the pins held where they rest, nothing pulled.
  void reset();

  /// k, Δt, w and m of the time step follow from the parameters, f_ext from positions and time too.
  void derive();

  /// f_ext alone: what changes from one time step to the next.
  void derive_forces();
};

/// Whether two states of a scene at the same positions have the same trace.
bool same_settings(const State& a, const State& b);

/// Which change between two states of a scene asks for a new factor of Q; empty when none does.
std::string reason_to_factorise(const State& before, const State& after);

}  // namespace mass_spring
