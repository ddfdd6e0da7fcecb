#include "simulation.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "as_points.h"
#include "checked_state.h"
#include "d2V_spring_particle_particle_dq2.h"
#include "dashpot_resistance.h"
#include "fastest_oscillation.h"
#include "forward_euler.h"
#include "gradient.h"
#include "local_step.h"
#include "matrix_from_triplets.h"
#include "reach_of.h"
#include "stability_limit.h"
#include "stiffness_numbers.h"
#include "system_matrix.h"
#include "triplets_from_matrix.h"
#include "validate_iterate.h"
#include "validate_system.h"

namespace mass_spring {
namespace {

const Status no_scene = {StatusCode::no_scene, "", -1, 0};
const double nan = std::numeric_limits<double>::quiet_NaN();

}  // namespace

Status Simulation::set_scene(const std::vector<double>& V, const std::vector<int>& E,
                             const std::vector<double>& m, const std::vector<int>& pinned,
                             const Parameters& parameters) {
  State next;
  Status status = checked_scene(V, E, m, pinned, parameters, next);
  if (!status.ok()) return status;
  status = replace(std::move(next), "scene", [this] { return seek(0); });
  if (status.ok()) history_.clear();
  return status;
}

Status Simulation::set_parameters(const Parameters& parameters) {
  State next = state_;
  const Status status = checked_parameters(parameters, next);
  return status.ok() ? replace_in_place(std::move(next)) : status;
}

Status Simulation::set_pins(const std::vector<int>& pinned, const std::vector<double>& targets) {
  State next = state_;
  const Status status = checked_pins(pinned, targets, next);
  return status.ok() ? replace_in_place(std::move(next)) : status;
}

Status Simulation::set_pull(const std::vector<int>& pulled, const std::vector<double>& targets,
                            double k) {
  State next = state_;
  const Status status = checked_pull(pulled, targets, k, next);
  return status.ok() ? replace_in_place(std::move(next)) : status;
}

Status Simulation::reset() {
  if (!has_scene()) return no_scene;
  State next = state_;
  next.reset();
  const std::string reason = reason_to_factorise(state_, next);
  const Status status = replace(std::move(next), reason, [this] { return seek(0); });
  if (status.ok()) history_.clear();
  return status;
}

Status Simulation::set_state(int step_number, const std::vector<double>& p_curr,
                             const std::vector<double>& p_prev, int half_step) {
  State next = state_;
  Status status = checked_moment(step_number, p_curr, p_prev, next);
  if (!status.ok()) return status;
  status = replace(std::move(next), "", [this, half_step] { return seek(half_step); });
  if (status.ok()) history_.clear();
  return status;
}

Status Simulation::step() {
  if (!has_scene()) return no_scene;
  return at_accept() ? advance([this] { return run(); }) : run();
}

Status Simulation::next_step() {
  if (!at_accept()) {
    const Status status = step();
    if (!status.ok()) return status;
  }
  return advance([this] { return seek(0); });
}

bool Simulation::back_to(int step_number) {
  const int steps = state_.step_number - step_number;
  if (steps < 1 || steps > history_.size()) return false;
  State earlier = state_;
  earlier.step_number = step_number;
  earlier.time_step.p_curr = history_.latest(steps).p_curr;
  earlier.time_step.p_prev = history_.latest(steps).p_prev;
  const bool returned =
      replace(std::move(earlier), "", [this] { return seek(last_half_step()); }).ok();
  if (returned) history_.drop_latest(steps);
  return returned;
}

Status Simulation::seek(int half_step) {
  if (!has_scene()) return no_scene;
  if (half_step < 0 || half_step > 2 * most_iterations() + 1) {
    return {StatusCode::index_out_of_range, "half_step", -1, static_cast<double>(half_step)};
  }
  if (minimises() && !outcome_ && trace_.recorded() == 0) {
    outcome_ = stop_at_start(stopping_rule(), minimiser_after(0));
  }
  // The end of a time step shows what the half-step before it made.
  Cursor cursor = trace_.start_for(std::min(half_step, last_half_step() - 1), state_.time_step);
  while (true) {
    if (cursor.half_step == trace_.recorded()) record(cursor);
    if (cursor.half_step == std::min(half_step, last_half_step())) break;
    next_half_step(cursor);
    const Status status = check_positions(cursor.iterate.p);
    if (!status.ok()) return status;
  }
  cursor_ = std::move(cursor);
  return {};
}

Status Simulation::compare(Method method, int iterations, std::vector<double>& rows) {
  rows.clear();
  if (!has_scene()) return no_scene;
  const Status status = system_.check(method, state_.time_step);
  if (!status.ok()) return status;
  const std::unique_ptr<Minimiser> minimiser = system_.minimiser(method, state_.time_step);
  minimiser->begin(state_.time_step.p_curr);
  const double objective = minimiser->objective();
  const auto add_row = [&](double decrease) {
    const double k = minimiser->iterations();
    rows.insert(rows.end(),
                {k, minimiser->objective() - objective, minimiser->gradient_norm(), decrease});
  };
  add_row(nan);
  for (bool moved = true; moved && minimiser->iterations() < iterations;) {
    const double objective_before = minimiser->objective();
    moved = minimiser->iterate();
    add_row(relative_decrease(objective_before, *minimiser));
  }
  return {};
}

/// Installs another state and lets `settle` put the cursor into it; if either fails, all is as
/// before.
/// @param reason  why Q must be factorised anew, or empty
template <typename Settle>
Status Simulation::replace(State next, const std::string& reason, Settle settle) {
  next.derive();
  Status status = validate_system(next.time_step, storage_in_use(next.parameters));
  if (!status.ok()) return status;
  std::swap(state_, next);
  Trace trace_before = std::exchange(trace_, {});
  const std::optional<Outcome> outcome_before = std::exchange(outcome_, {});
  const Method method = next.parameters.method;  // until now
  if (!reason.empty() || method != state_.parameters.method) minimiser_.reset();
  status = prepare(reason);
  if (status.ok()) status = system_.check(state_.parameters.method, state_.time_step);
  if (status.ok()) status = settle();
  if (!status.ok()) {
    std::swap(state_, next);
    trace_ = std::move(trace_before);
    outcome_ = outcome_before;
    minimiser_.reset();
    prepare(reason);
  } else if (!reason.empty()) {
    ++factorisation_count_;
    factorisation_reason_ = reason;
  }
  return status;
}

/// Leaves the cursor where it is. Inside a time step it is traced anew up to there; at accept the
/// accepted positions stay.
Status Simulation::replace_in_place(State next) {
  if (same_settings(state_, next)) return {};  // and the trace so far stays
  const std::string reason = reason_to_factorise(state_, next);
  if (at_accept()) {
    return replace(std::move(next), reason, [this] {
      cursor_.half_step = last_half_step();
      return Status{};
    });
  }
  return replace(std::move(next), reason,
                 [this] { return seek(std::min(cursor_.half_step, last_half_step())); });
}

/// From accept to the next time step: p^{t-Δt} <- p^t, p^t <- p. If `settle` fails, all is as
/// before.
template <typename Settle>
Status Simulation::advance(Settle settle) {
  TimeStep& step = state_.time_step;
  Departure before = {step.p_curr, step.p_prev};
  step.p_prev = settled_previous();
  step.p_curr = cursor_.iterate.p;
  state_.step_number += 1;
  state_.derive_forces();
  Trace trace_before = std::exchange(trace_, {});
  const std::optional<Outcome> outcome_before = std::exchange(outcome_, {});
  begin();
  const Status status = settle();
  if (status.ok()) {
    history_.push(std::move(before));
    return status;
  }
  step.p_curr = std::move(before.p_curr);
  step.p_prev = std::move(before.p_prev);
  state_.step_number -= 1;
  state_.derive_forces();
  trace_ = std::move(trace_before);
  outcome_ = outcome_before;
  begin();
  return status;
}

/// Brings system and right-hand side up to date with state_.
Status Simulation::prepare(const std::string& reason) {
  if (!has_scene()) return {};  // there was none before the one that failed
  TimeStep& step = state_.time_step;
  if (reason.empty()) {
    system_.reorder_pins(step);  // the same set may be listed in another order
  } else {
    if (reason == "scene" || reason == "path" || reason == "storage") {
      system_.clear(state_.parameters);
    }
    const Status status = system_.precompute(state_.V, step, step.r);
    if (!status.ok()) return status;
  }
  begin();
  return {};
}

void Simulation::begin() {
  system_.begin(state_.time_step, workspace_);
  y_is_current_ = state_.parameters.path == Path::plain;
  minimiser_has_begun_ = false;
}

int Simulation::most_iterations() const {
  return takes_one_step(state_.parameters.method) ? 1 : state_.parameters.iterations;
}

StoppingRule Simulation::stopping_rule() const {
  const Parameters& parameters = state_.parameters;
  if (takes_one_step(parameters.method)) return {1};
  return {parameters.iterations, parameters.stop_gradient, parameters.stop_decrease};
}

/// Whether a minimiser makes the iterates. Where nothing but K ends a time step, and only springs
/// and pins act, local and global step do it by themselves, as the course spells them out.
bool Simulation::minimises() const {
  const Parameters& parameters = state_.parameters;
  return parameters.damping > 0 || state_.time_step.pull.vertices.size() > 0 ||
         parameters.method != Method::local_global || parameters.stop_gradient > 0 ||
         parameters.stop_decrease > 0;
}

/// The minimiser after so many iterations of this time step.
Minimiser& Simulation::minimiser_after(int iterations) {
  if (!minimiser_) minimiser_ = system_.minimiser(state_.parameters.method, state_.time_step);
  if (!minimiser_has_begun_ || minimiser_->iterations() > iterations) {
    minimiser_->begin(state_.time_step.p_curr);
    minimiser_has_begun_ = true;
  }
  while (minimiser_->iterations() < iterations) minimiser_->iterate();
  return *minimiser_;
}

/// The whole time step at full speed, nothing recorded.
Status Simulation::run() {
  const TimeStep& step = state_.time_step;
  Iterate& iterate = spare_.iterate;
  Outcome outcome = {StopReason::iterations, most_iterations()};
  if (minimises()) {
    Minimiser& minimiser = minimiser_after(0);
    std::optional<Outcome> end = stop_at_start(stopping_rule(), minimiser);
    minimiser.positions(iterate.p_before);
    while (!end) {
      minimiser.positions(iterate.p_before);
      end = iterate_once(stopping_rule(), minimiser);
    }
    outcome = *end;
    minimiser.positions(iterate.p);
    local_step(step.E, step.r, iterate.p_before, iterate.d);
  } else {
    system_.fast_mass_springs_step(step, workspace_, iterate, outcome.iterations);
  }
  const Status status = check_positions(iterate.p);
  if (!status.ok()) return status;
  outcome_ = outcome;
  spare_.half_step = last_half_step();
  spare_.next_p_prev = next_p_prev();
  std::swap(cursor_, spare_);
  return status;
}

void Simulation::next_half_step(Cursor& cursor) {
  ++cursor.half_step;
  if (cursor.half_step == last_half_step()) {  // accept moves nothing
    cursor.next_p_prev = next_p_prev();
    return;
  }
  const TimeStep& step = state_.time_step;
  Iterate& iterate = cursor.iterate;
  if (cursor.half_step % 2 == 1) {
    local_step(step.E, step.r, iterate.p, iterate.d);
    return;
  }
  iterate.p.swap(iterate.p_before);
  const int k = cursor.half_step / 2;
  if (minimises()) {
    Minimiser& minimiser = minimiser_after(k - 1);
    const std::optional<Outcome> outcome = iterate_once(stopping_rule(), minimiser);
    if (outcome) outcome_ = outcome;
    minimiser.positions(iterate.p);
    return;
  }
  system_.global_step(step, workspace_, iterate);
  if (k == most_iterations()) outcome_ = {StopReason::iterations, k};
}

void Simulation::record(const Cursor& cursor) {
  const TimeStep& step = state_.time_step;
  double residual = nan;  // N
  const bool by_springs = step.damping == 0 && step.pull.vertices.size() == 0;
  if (cursor.at_global() && by_springs && state_.parameters.method == Method::local_global) {
    y();
    residual = system_.residual(step, cursor.iterate, workspace_);
  }
  trace_.append(step, cursor, residual, most_iterations());
}

const Points& Simulation::y() {
  if (has_scene() && !y_is_current_) {
    system_.inertial_right_hand_side(state_.time_step, workspace_.y);
    y_is_current_ = true;
  }
  return workspace_.y;
}

VertexProbe Simulation::probe_vertex(int i) {
  if (i < 0 || i >= state_.V.rows()) {
    const Eigen::RowVector3d nowhere = Eigen::RowVector3d::Constant(nan);
    return {nowhere, nowhere, nowhere, nowhere, {}, {}};
  }
  return system_.probe(state_.time_step, cursor_.iterate, y(), i);
}

Objective Simulation::objective_at(const std::vector<double>& p) const {
  if (!has_scene() || p.size() != static_cast<std::size_t>(state_.V.size())) {
    return {nan, nan, nan, nan, nan, nan, nan};
  }
  return objective(state_.time_step, as_points(p));
}

Points Simulation::gradient_at(const std::vector<double>& p) const {
  Points g(0, 3);  // #V by 3, N
  if (p.size() == static_cast<std::size_t>(state_.V.size())) {
    gradient(state_.time_step, as_points(p), g);
  }
  return g;
}

void Simulation::rehearse_local_step(int times) {
  if (has_scene()) system_.rehearse_local_step(state_.time_step, times);
}

void Simulation::rehearse_global_step(int times) {
  if (has_scene()) system_.rehearse_global_step(state_.time_step, times);
}

MechanicalEnergy Simulation::energy() const {
  const TimeStep& step = state_.time_step;
  if (!has_scene()) return {};
  return mechanical_energy(step, settled(), settled_previous());
}

Points Simulation::velocity() const {
  if (!has_scene()) return Points(0, 3);
  return (settled() - settled_previous()) / state_.time_step.delta_t;
}

double Simulation::frequency() const {
  return has_scene() ? fastest_oscillation(state_.time_step, settled()).omega : 0;
}

double Simulation::stability_limit() const {
  const Oscillation fastest =
      has_scene() ? fastest_oscillation(state_.time_step, settled()) : Oscillation{};
  return mass_spring::stability_limit(state_.parameters.method, fastest.zeta);
}

const Points& Simulation::settled() const {
  return at_accept() ? cursor_.iterate.p : state_.time_step.p_curr;
}

/// A Δt before settled(), such that their difference is the velocity.
const Points& Simulation::settled_previous() const {
  return at_accept() ? cursor_.next_p_prev : state_.time_step.p_prev;
}

/// Of a time step that is being accepted.
Points Simulation::next_p_prev() const {
  const TimeStep& step = state_.time_step;
  return state_.parameters.method == Method::forward_euler ? forward_euler_previous(step)
                                                           : step.p_curr;
}

/// Whether a motion can come there; if not, by what.
Status Simulation::check_positions(const Points& p) const {
  const Method method = state_.parameters.method;
  const Status status = validate_iterate(p);
  if (!is_explicit(method)) return status;
  const double reach = reach_of(state_.V);  // m
  int farthest;
  const double distance = p.rowwise().lpNorm<Eigen::Infinity>().maxCoeff(&farthest);  // m
  if (status.ok() && distance <= reach) return status;
  // Where it has exploded, springs are long and stiff in all directions: a larger ω than that which
  // it exploded of. Unless it was long already.
  const TimeStep& step = state_.time_step;
  for (const Points* q : {&state_.V, &step.p_curr}) {
    const Oscillation fastest = fastest_oscillation(step, *q);
    const double product = step.delta_t * fastest.omega;
    const double limit = mass_spring::stability_limit(method, fastest.zeta);
    if (product > limit) {
      return {StatusCode::unstable, method_names()[static_cast<int>(method)], -1, product, limit};
    }
  }
  if (!status.ok()) return status;
  return {StatusCode::diverged, "p", farthest, distance, reach};
}

double Simulation::stiffness_number() const {
  const TimeStep& step = state_.time_step;
  return has_scene() ? stiffness_numbers(step.E, step.k, step.m, step.delta_t).maxCoeff() : 0;
}

LinearlyImplicitTerms Simulation::linearly_implicit_terms() const {
  return mass_spring::linearly_implicit_terms(state_.time_step, settled());
}

Eigen::Matrix3d Simulation::spring_stiffness(int e) const {
  if (!has_spring(e)) return Eigen::Matrix3d::Constant(nan);
  const TimeStep& step = state_.time_step;
  const Points& q = settled();
  return d2V_spring_particle_particle_dq2(q.row(step.E(e, 0)), q.row(step.E(e, 1)), step.r(e),
                                          step.k)
      .topLeftCorner<3, 3>();
}

Eigen::Matrix3d Simulation::spring_resistance(int e) const {
  if (!has_spring(e)) return Eigen::Matrix3d::Constant(nan);
  const TimeStep& step = state_.time_step;
  const Points& q = settled();
  return dashpot_resistance(q.row(step.E(e, 0)), q.row(step.E(e, 1)), step.damping);
}

Triplets Simulation::Q() const {
  const TimeStep& step = state_.time_step;
  const int n = static_cast<int>(step.m.size());
  SparseMatrix Q;
  matrix_from_triplets(n, n, system_matrix(step), Q);
  return triplets_from_matrix(Q);
}

}  // namespace mass_spring
