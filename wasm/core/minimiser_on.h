#pragma once

#include <utility>

#include "minimiser.h"

namespace mass_spring {

/// @tparam Method   LocalGlobal, Chebyshev, Anderson, Lbfgs or Newton, over Problem
/// @tparam Problem  FastProblem, PlainProblem or NewtonProblem
template <typename Method, typename Problem>
class MinimiserOn : public Minimiser {
 public:
  explicit MinimiserOn(Problem problem) : problem_(std::move(problem)) {}

  double objective() const override { return method_.standing().objective; }
  double objective_offset() const override { return problem_.objective_offset(); }
  double gradient_norm() const override {
    return problem_.gradient_norm(method_.standing().gradient);
  }
  void positions(Points& p) const override { problem_.points_from_field(p_, p); }

 private:
  void start(const Points& p) override {
    p_ = problem_.field_from_points(p);
    method_.begin(problem_, p_);
  }
  bool advance() override { return method_.iterate(problem_, p_); }

  Problem problem_;
  Method method_;
  typename Problem::Field p_;  // m
};

}  // namespace mass_spring
