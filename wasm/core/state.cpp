#include "state.h"

#include "bounding_box_diagonal.h"
#include "gravity.h"
#include "same_set.h"
#include "wind.h"

namespace mass_spring {

void State::reset() {
  step_number = 1;
  time_step.p_curr = V;
  time_step.p_prev = V;
  time_step.pull = {};
  time_step.targets.resize(time_step.pinned.size(), 3);
  for (int c = 0; c < time_step.pinned.size(); ++c) {
    time_step.targets.row(c) = V.row(time_step.pinned(c));
  }
}

void State::derive() {
  time_step.k = parameters.k;
  time_step.delta_t = parameters.delta_t;
  time_step.w = parameters.w;
  time_step.damping = parameters.damping;
  time_step.m = parameters.mass_scale * scene_m;
  derive_forces();
}

void State::derive_forces() {
  gravity(time_step.m, parameters.gravity, time_step.f_ext);
  if (parameters.wind) {
    const double time = step_number * parameters.delta_t;  // s
    wind(time_step.m, bounding_box_diagonal(V), time, time_step.p_curr, time_step.f_ext);
  }
}

static bool same_pull(const Pull& a, const Pull& b) {
  return a.vertices.size() == b.vertices.size() && a.vertices == b.vertices &&
         a.targets == b.targets && a.k == b.k;
}

bool same_settings(const State& a, const State& b) {
  const TimeStep& s = a.time_step;
  const TimeStep& t = b.time_step;
  return a.parameters == b.parameters && s.pinned.size() == t.pinned.size() &&
         s.pinned == t.pinned && s.targets == t.targets && same_pull(s.pull, t.pull);
}

std::string reason_to_factorise(const State& before, const State& after) {
  if (before.parameters.path != after.parameters.path) return "path";
  const bool plain = after.parameters.path == Path::plain;
  if (plain && before.parameters.storage != after.parameters.storage) return "storage";
  if (before.parameters.k != after.parameters.k) return "k";
  if (before.parameters.delta_t != after.parameters.delta_t) return "delta_t";
  if (before.parameters.mass_scale != after.parameters.mass_scale) return "mass";
  if (plain && before.parameters.w != after.parameters.w) return "w";
  if (before.parameters.damping != after.parameters.damping) return "damping";
  if (!same_set(before.time_step.pinned, after.time_step.pinned)) return "pins";
  const Pull& a = before.time_step.pull;
  const Pull& b = after.time_step.pull;
  if (!same_set(a.vertices, b.vertices) || (a.vertices.size() > 0 && a.k != b.k)) return "pull";
  return "";
}

}  // namespace mass_spring
