#pragma once

#include <string>
#include <vector>

#include "mechanical_energy.h"
#include "mistakable_solver.h"
#include "mistake.h"
#include "objective.h"
#include "state.h"
#include "status.h"

namespace mass_spring {

/// A simulation with a mistake in it, apart from the trusted one.
/// web/src/solver/mistaken_simulation.ts documents every call; arrays come in row-major and
/// unchecked. A call that fails leaves everything as it was, but for a time step that diverges: it
/// stays at the half-step that did.
class MistakenSimulation {
 public:
  Status set_scene(const std::vector<double>& V, const std::vector<int>& E,
                   const std::vector<double>& m, const std::vector<int>& pinned,
                   const Parameters& parameters, Mistake mistake);
  Status set_parameters(const Parameters& parameters);
  Status set_pins(const std::vector<int>& pinned, const std::vector<double>& targets);
  Status reset();
  Status set_state(int step_number, const std::vector<double>& p_curr,
                   const std::vector<double>& p_prev, int half_step);

  Status step();

  int step_number() const { return state_.step_number; }
  int half_step() const { return half_step_; }
  int last_half_step() const { return 2 * state_.parameters.iterations + 1; }
  const TimeStep& time_step() const { return state_.time_step; }
  const Points& p() const { return at_accept() ? solver_.p() : state_.time_step.p_curr; }
  /// The right one. Not-a-numbers where p is not #V by 3.
  Objective objective_at(const std::vector<double>& p) const;
  /// Of p(), the settled positions.
  MechanicalEnergy energy() const;
  const MistakableSolver& solver() const { return solver_; }

 private:
  bool has_scene() const { return state_.V.rows() > 0; }
  bool at_accept() const { return has_scene() && half_step_ == last_half_step(); }
  Status replace(State next, Mistake mistake, const std::string& reason);
  Status replace_in_place(State next);
  bool prepare();
  void begin();

  State state_;
  Mistake mistake_ = Mistake::none;
  MistakableSolver solver_;
  int half_step_ = 0;
  Status failure_;  // of the current time step
};

}  // namespace mass_spring
