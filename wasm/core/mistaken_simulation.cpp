#include "mistaken_simulation.h"

#include <limits>
#include <utility>

#include "as_points.h"
#include "checked_state.h"
#include "edge_lengths.h"
#include "reach_of.h"
#include "validate_iterate.h"
#include "validate_system.h"

namespace mass_spring {
namespace {

const double nan = std::numeric_limits<double>::quiet_NaN();
// Bytes of Q and L with every zero stored: 1,290 vertices, whose factorisation takes seconds.
constexpr double largest_stored_zeros = 30e6;

Status validate_zeros(int n) {
  const double bytes = 1.5 * n * n * (sizeof(double) + sizeof(int));
  if (bytes <= largest_stored_zeros) return {};
  return {StatusCode::too_large, "zeros", -1, bytes, largest_stored_zeros};
}

}  // namespace

Status MistakenSimulation::set_scene(const std::vector<double>& V, const std::vector<int>& E,
                                     const std::vector<double>& m, const std::vector<int>& pinned,
                                     const Parameters& parameters, Mistake mistake) {
  State next;
  Status status = checked_scene(V, E, m, pinned, parameters, next);
  if (status.ok()) status = replace(std::move(next), mistake, "scene");
  if (status.ok()) begin();
  return status;
}

Status MistakenSimulation::set_parameters(const Parameters& parameters) {
  State next = state_;
  const Status status = checked_parameters(parameters, next);
  return status.ok() ? replace_in_place(std::move(next)) : status;
}

Status MistakenSimulation::set_pins(const std::vector<int>& pinned,
                                    const std::vector<double>& targets) {
  State next = state_;
  const Status status = checked_pins(pinned, targets, next);
  return status.ok() ? replace_in_place(std::move(next)) : status;
}

Status MistakenSimulation::reset() {
  if (!has_scene()) return {StatusCode::no_scene, "", -1, 0};
  state_.reset();
  begin();
  return {};
}

Status MistakenSimulation::set_state(int step_number, const std::vector<double>& p_curr,
                                     const std::vector<double>& p_prev, int half_step) {
  if (half_step != 0) {
    return {StatusCode::index_out_of_range, "half_step", -1, static_cast<double>(half_step)};
  }
  const Status status = checked_moment(step_number, p_curr, p_prev, state_);
  if (status.ok()) begin();
  return status;
}

Status MistakenSimulation::step() {
  if (!has_scene()) return {StatusCode::no_scene, "", -1, 0};
  if (!failure_.ok()) return failure_;
  TimeStep& step = state_.time_step;
  if (at_accept()) {
    step.p_prev = std::move(step.p_curr);
    step.p_curr = solver_.p();
    state_.step_number += 1;
    state_.derive_forces();
  }
  const double reach = reach_of(state_.V);
  solver_.solve(step, state_.V, state_.parameters.iterations, reach);
  half_step_ = solver_.is_finite() ? last_half_step() : 2 * solver_.global_steps();
  failure_ = validate_iterate(solver_.p());
  if (failure_.ok() && !solver_.is_finite()) {
    const int i = solver_.unbounded_vertex();
    failure_ = {StatusCode::diverged, "p", i, solver_.p().row(i).lpNorm<Eigen::Infinity>(), reach};
  }
  return failure_;
}

Objective MistakenSimulation::objective_at(const std::vector<double>& p) const {
  if (!has_scene() || p.size() != static_cast<std::size_t>(state_.V.size())) {
    return {nan, nan, nan, nan, nan, nan, nan};
  }
  return objective(state_.time_step, as_points(p));
}

MechanicalEnergy MistakenSimulation::energy() const {
  if (!has_scene()) return {};
  const TimeStep& step = state_.time_step;
  return at_accept() ? mechanical_energy(step, solver_.p(), step.p_curr)
                     : mechanical_energy(step, step.p_curr, step.p_prev);
}

/// To predict.
void MistakenSimulation::begin() {
  state_.derive_forces();
  half_step_ = 0;
  failure_ = {};
}

/// Leaves the cursor where it is, also where a time step failed.
Status MistakenSimulation::replace_in_place(State next) {
  const bool accepted = at_accept();
  next.parameters.path = Path::plain;  // as in state_: the path is no reason to factorise
  std::string reason = reason_to_factorise(state_, next);
  if (reason.empty() && next.time_step.pinned != state_.time_step.pinned) reason = "order of pins";
  const Status status = replace(std::move(next), mistake_, reason);
  if (accepted) half_step_ = last_half_step();
  return status;
}

/// Installs another state; if that fails, all is as before.
/// @param reason  why the matrices must be made anew, or empty
Status MistakenSimulation::replace(State next, Mistake mistake, const std::string& reason) {
  next.parameters.path = Path::plain;
  next.parameters.storage = Storage::sparse;
  next.parameters.damping = 0;  // none of the course's mistakes is about dashpots
  next.derive();
  Status status = validate_system(next.time_step, Storage::sparse);
  if (status.ok() && mistake == Mistake::stored_zeros) status = validate_zeros(next.V.rows());
  if (!status.ok()) return status;
  std::swap(state_, next);
  std::swap(mistake_, mistake);
  if (reason.empty() || prepare()) return {};
  std::swap(state_, next);
  std::swap(mistake_, mistake);
  if (has_scene()) prepare();
  return {StatusCode::factorisation_failed, "Q", -1, nan};
}

bool MistakenSimulation::prepare() {
  TimeStep& step = state_.time_step;
  edge_lengths(state_.V, step.E, step.r);
  return solver_.precompute(mistake_, step);
}

}  // namespace mass_spring
