#pragma once

#include "gradient.h"
#include "largest_free_component.h"
#include "minimiser.h"
#include "objective.h"
#include "time_step.h"

namespace mass_spring {

/// A method that takes a time step at once, seen as one that iterates: its first iteration is the
/// step, and no further one moves. Nothing says that E falls. Lends the step.
/// @tparam Integrator  LinearlyImplicitEuler, SymplecticEuler or ForwardEuler, with
///   void operator()(const TimeStep& step, Points& p);  // p: #V by 3, m, at t + Δt (result)
template <typename Integrator>
class SingleStepBy : public Minimiser {
 public:
  explicit SingleStepBy(const TimeStep& step) : step_(step) {}

  double objective() const override { return mass_spring::objective(step_, p_).objective; }
  double objective_offset() const override { return 0; }
  double gradient_norm() const override {
    Points g;  // #V by 3, N
    gradient(step_, p_, g);
    return largest_free_component(g, step_.pinned);
  }
  void positions(Points& p) const override { p = p_; }

 private:
  void start(const Points& p) override { p_ = p; }
  bool advance() override {
    if (iterations() > 1) return false;
    integrator_(step_, p_);
    return true;
  }

  const TimeStep& step_;
  Integrator integrator_;
  Points p_;  // #V by 3, m
};

}  // namespace mass_spring
