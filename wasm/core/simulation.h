#pragma once

#include <string>
#include <vector>

#include "history.h"
#include "objective.h"
#include "parameters.h"
#include "state.h"
#include "status.h"
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
  Status set_scene(const std::vector<double>& V, const std::vector<int>& E,
                   const std::vector<double>& m, const std::vector<int>& pinned,
                   const Parameters& parameters);
  Status set_parameters(const Parameters& parameters);
  Status set_pins(const std::vector<int>& pinned, const std::vector<double>& targets);
  Status reset();
  Status set_state(int step_number, const std::vector<double>& p_curr,
                   const std::vector<double>& p_prev, int half_step);

  Status step();
  Status seek(int half_step);
  Status next_step();
  bool previous_step();
  int remembered_steps() const { return history_.size(); }

  int step_number() const { return state_.step_number; }
  int half_step() const { return cursor_.half_step; }
  int last_half_step() const { return 2 * state_.parameters.iterations + 1; }

  /// What the current time step is given; everything but p, d and the trace is in it.
  const TimeStep& time_step() const { return state_.time_step; }
  /// p, p_before and d of the cursor.
  const Iterate& iterate() const { return cursor_.iterate; }
  const Points& y() const { return workspace_.y; }
  const Trace& trace() const { return trace_; }

  /// Not-a-numbers where there is no vertex i.
  VertexProbe probe_vertex(int i) const;
  /// Not-a-numbers where p is not #V by 3.
  Objective objective_at(const std::vector<double>& p) const;
  /// No rows where p is not #V by 3.
  Points gradient_at(const std::vector<double>& p) const;
  double stiffness_number() const;
  /// Without those of calls that failed.
  int factorisation_count() const { return factorisation_count_; }
  const std::string& factorisation_reason() const { return factorisation_reason_; }

  Triplets A() const { return system_.A(); }
  Triplets M() const { return system_.M(); }
  Triplets C() const { return system_.C(); }
  Triplets Q() const;

 private:
  bool has_scene() const { return state_.V.rows() > 0; }
  bool at_accept() const { return has_scene() && cursor_.half_step == last_half_step(); }
  template <typename Settle>
  Status replace(State next, const std::string& reason, Settle settle);
  template <typename Settle>
  Status advance(Settle settle);
  Status replace_in_place(State next);
  Status prepare(const std::string& reason);
  Status run();
  void next_half_step(Cursor& cursor);
  void record(const Cursor& cursor);

  State state_;
  System system_;
  Workspace workspace_;
  Cursor cursor_;
  Trace trace_;  // of state_; empty when nothing of it was traced
  History history_;
  int factorisation_count_ = 0;
  std::string factorisation_reason_;
};

}  // namespace mass_spring
