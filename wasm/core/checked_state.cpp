#include "checked_state.h"

#include <cmath>

#include "as_points.h"
#include "validate_masses.h"
#include "validate_parameters.h"
#include "validate_points.h"
#include "validate_springs.h"
#include "validate_vertices.h"

namespace mass_spring {
namespace {

const Status no_scene = {StatusCode::no_scene, "", -1, 0};

Indices as_indices(const std::vector<int>& values) {
  return Eigen::Map<const Indices>(values.data(), values.size());
}

int vertices(const State& state) { return static_cast<int>(state.V.rows()); }

}  // namespace

Status checked_scene(const std::vector<double>& V, const std::vector<int>& E,
                     const std::vector<double>& m, const std::vector<int>& pinned,
                     const Parameters& parameters, State& state) {
  const int n = static_cast<int>(V.size() / 3);
  for (const Status& status :
       {validate_points("V", V, n), n > 0 ? Status{} : Status{StatusCode::no_vertices, "V", -1, 0},
        validate_springs(E, n), validate_masses(m, n), validate_vertices("pinned", pinned, n),
        validate_parameters(parameters)}) {
    if (!status.ok()) return status;
  }
  state.V = as_points(V);
  state.scene_m = Eigen::Map<const Vector>(m.data(), n);
  state.parameters = parameters;
  state.time_step.E = Eigen::Map<const Edges>(E.data(), E.size() / 2, 2);
  state.time_step.pinned = as_indices(pinned);
  state.reset();
  return {};
}

Status checked_parameters(const Parameters& parameters, State& state) {
  if (vertices(state) == 0) return no_scene;
  const Status status = validate_parameters(parameters);
  if (status.ok()) state.parameters = parameters;
  return status;
}

Status checked_pins(const std::vector<int>& pinned, const std::vector<double>& targets,
                    State& state) {
  if (vertices(state) == 0) return no_scene;
  for (const Status& status :
       {validate_vertices("pinned", pinned, vertices(state)),
        validate_points("targets", targets, static_cast<int>(pinned.size()))}) {
    if (!status.ok()) return status;
  }
  state.time_step.pinned = as_indices(pinned);
  state.time_step.targets = as_points(targets);
  return {};
}

Status checked_pull(const std::vector<int>& pulled, const std::vector<double>& targets, double k,
                    State& state) {
  if (vertices(state) == 0) return no_scene;
  for (const Status& status :
       {validate_vertices("pulled", pulled, vertices(state)),
        validate_points("targets", targets, static_cast<int>(pulled.size()))}) {
    if (!status.ok()) return status;
  }
  if (!std::isfinite(k)) return {StatusCode::not_finite, "pull", -1, k};
  if (k < 0) return {StatusCode::negative, "pull", -1, k};
  state.time_step.pull = {as_indices(pulled), as_points(targets), k};
  return {};
}

Status checked_moment(int step_number, const std::vector<double>& p_curr,
                      const std::vector<double>& p_prev, State& state) {
  if (vertices(state) == 0) return no_scene;
  for (const Status& status : {validate_points("p_curr", p_curr, vertices(state)),
                               validate_points("p_prev", p_prev, vertices(state))}) {
    if (!status.ok()) return status;
  }
  if (step_number < 1) {
    return {StatusCode::not_positive, "step", -1, static_cast<double>(step_number)};
  }
  state.step_number = step_number;
  state.time_step.p_curr = as_points(p_curr);
  state.time_step.p_prev = as_points(p_prev);
  return {};
}

}  // namespace mass_spring
