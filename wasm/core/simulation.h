#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "history.h"
#include "linearly_implicit_terms.h"
#include "mechanical_energy.h"
#include "minimiser.h"
#include "objective.h"
#include "parameters.h"
#include "state.h"
#include "status.h"
#include "stopping_rule.h"
#include "system.h"
#include "time_step.h"
#include "trace.h"

namespace mass_spring {

/// A scene, its parameters and pins, the known positions, and a cursor inside the time step that
/// computes the next ones. web/src/solver/module.ts documents every call; arrays come in row-major
/// and unchecked, references go out until the next call. A call that fails leaves everything as it
/// was.
class Simulation {
 public:
  /// Iteration, E(p^k) - E(p^0) in J, ‖∂E/∂p^k‖∞ in N and relative_decrease, of every iteration.
  static constexpr int compare_columns = 4;

  void set_progress(StageProgress progress) { system_.set_progress(std::move(progress)); }

  Status set_scene(const std::vector<double>& V, const std::vector<int>& E,
                   const std::vector<double>& m, const std::vector<int>& pinned,
                   const Parameters& parameters);
  Status set_parameters(const Parameters& parameters);
  Status set_pins(const std::vector<int>& pinned, const std::vector<double>& targets);
  Status set_pull(const std::vector<int>& pulled, const std::vector<double>& targets, double k);
  Status reset();
  Status set_state(int step_number, const std::vector<double>& p_curr,
                   const std::vector<double>& p_prev, int half_step);

  Status step();
  Status seek(int half_step);
  Status next_step();
  /// Back to accept of an earlier time step that is remembered, which is retraced.
  bool back_to(int step_number);
  bool previous_step() { return back_to(state_.step_number - 1); }
  int remembered_steps() const { return history_.size(); }

  int step_number() const { return state_.step_number; }
  int half_step() const { return cursor_.half_step; }
  int last_half_step() const { return 2 * iterations() + 1; }
  /// How the time step ends, once that is known.
  const std::optional<Outcome>& outcome() const { return outcome_; }

  /// What the current time step is given; everything but p, d and the trace is in it.
  const TimeStep& time_step() const { return state_.time_step; }
  /// p, p_before and d of the cursor.
  const Iterate& iterate() const { return cursor_.iterate; }
  const Points& y();
  const Trace& trace() const { return trace_; }

  /// Not-a-numbers where there is no vertex i.
  VertexProbe probe_vertex(int i);
  /// Not-a-numbers where p is not #V by 3.
  Objective objective_at(const std::vector<double>& p) const;
  /// No rows where p is not #V by 3.
  Points gradient_at(const std::vector<double>& p) const;
  /// @param rows  #iterations + 1 by compare_columns, row-major (result)
  Status compare(Method method, int iterations, std::vector<double>& rows);
  /// So many local or global steps from p^t whose results nobody uses: to be timed.
  void rehearse_local_step(int times);
  void rehearse_global_step(int times);
  /// Of the settled positions: at accept p, elsewhere p^t.
  MechanicalEnergy energy() const;
  /// #V by 3, m/s: likewise.
  Points velocity() const;
  /// rad/s: at the settled positions.
  double frequency() const;
  /// What Δt times frequency() may be before the method no longer holds it; infinite if any.
  double stability_limit() const;
  double stiffness_number() const;
  /// Without those of calls that failed.
  int factorisation_count() const { return factorisation_count_; }
  const std::string& factorisation_reason() const { return factorisation_reason_; }

  Triplets A() const { return system_.A(); }
  Triplets M() const { return system_.M(); }
  Triplets C() const { return system_.C(); }
  Triplets Q() const;
  /// Of linearly implicit Euler, at the settled positions.
  LinearlyImplicitTerms linearly_implicit_terms() const;
  /// #V by 3, m: where the last time step that is over left them; at accept p, elsewhere p^t.
  const Points& settled() const;
  /// H_e of spring e at the settled positions, N/m, and what its dashpot is there, N s/m;
  /// not-a-numbers where there is no spring e.
  Eigen::Matrix3d spring_stiffness(int e) const;
  Eigen::Matrix3d spring_resistance(int e) const;
  /// Which unknown of Q p = b, a vertex, the solver eliminates first, second, …
  std::vector<int> order() const { return system_.order(); }

 private:
  bool has_scene() const { return state_.V.rows() > 0; }
  bool at_accept() const { return has_scene() && cursor_.half_step == last_half_step(); }
  /// Of this time step; K as long as its end is not known.
  int iterations() const { return outcome_ ? outcome_->iterations : most_iterations(); }
  int most_iterations() const;
  StoppingRule stopping_rule() const;
  bool has_spring(int e) const { return 0 <= e && e < state_.time_step.E.rows(); }
  const Points& settled_previous() const;
  Points next_p_prev() const;
  Status check_positions(const Points& p) const;
  bool minimises() const;
  template <typename Settle>
  Status replace(State next, const std::string& reason, Settle settle);
  template <typename Settle>
  Status advance(Settle settle);
  Status replace_in_place(State next);
  Status prepare(const std::string& reason);
  void begin();
  Status run();
  void next_half_step(Cursor& cursor);
  void record(const Cursor& cursor);
  Minimiser& minimiser_after(int iterations);

  State state_;
  System system_;
  Workspace workspace_;
  bool y_is_current_ = false;
  Cursor cursor_;
  Cursor spare_;  // keeps its memory from step to step
  Trace trace_;   // of state_; empty when nothing of it was traced
  std::optional<Outcome> outcome_;
  std::unique_ptr<Minimiser> minimiser_;  // of state_'s method; none before it is used
  bool minimiser_has_begun_ = false;      // this time step
  History history_;
  int factorisation_count_ = 0;
  std::string factorisation_reason_;
};

}  // namespace mass_spring
