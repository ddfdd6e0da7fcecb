#include "newton.h"

#include <array>
#include <limits>

#include "backtrack.h"
#include "gradient.h"
#include "hessian.h"
#include "inner_product.h"
#include "objective.h"
#include "objective_change.h"

namespace mass_spring {
namespace {

constexpr std::array<double, 6> shares_left_out = {0, 1.0 / 256, 1.0 / 64, 1.0 / 16, 1.0 / 4, 1};

// Moves of the last digit of p are rounding, and could go on for ever.
constexpr double resolution = 2 * std::numeric_limits<double>::epsilon();

}  // namespace

Points NewtonProblem::field_from_points(Points p) const {
  if (holds_pins()) p(step_.pinned, Eigen::all) = step_.targets;
  return p;
}

void Newton::begin(const NewtonProblem& problem, const Points& p) {
  standing_ = {};
  caution_ = 0;
  evaluate(problem, p);
}

bool Newton::iterate(const NewtonProblem& problem, Points& p) {
  // A little bolder than last time, then ever more cautious.
  if (caution_ > 0) --caution_;
  for (; caution_ < shares_left_out.size(); ++caution_) {
    const Descent descent = descend(problem, shares_left_out[caution_], p);
    if (descent != Descent::not_convex) return descent == Descent::moved;
  }
  return false;
}

void Newton::evaluate(const NewtonProblem& problem, const Points& p) {
  const TimeStep& step = problem.step();
  standing_.objective = objective(step, p).objective;
  gradient(step, p, standing_.gradient);
  if (problem.holds_pins()) standing_.gradient(step.pinned, Eigen::all).setZero();
  ++standing_.gradient_evaluations;
}

/// p ← p - α H⁻¹ ∂E/∂p, if that lowers E.
Newton::Descent Newton::descend(const NewtonProblem& problem, double left_out, Points& p) {
  const TimeStep& step = problem.step();
  const int n = static_cast<int>(p.rows());
  const Indices held = problem.holds_pins() ? step.pinned : Indices();
  if (!H_.fits(step.E, n, held)) {
    H_.analyse(step.E, n, held);
    llt_.analyzePattern(H_.matrix());
  }
  hessian(step, p, left_out, H_);
  llt_.factorize(H_.matrix());
  if (llt_.info() != Eigen::Success) return Descent::not_convex;
  H_.gather(standing_.gradient, g_);
  g_ = llt_.solve(g_);
  x_.setZero(n, 3);
  H_.scatter(g_, x_);
  ++standing_.solves;
  if (x_.cwiseAbs().maxCoeff() <= resolution * p.cwiseAbs().maxCoeff()) return Descent::ended;
  const double slope = -inner_product(x_, standing_.gradient);
  if (!(slope < 0)) return Descent::not_convex;  // not-a-number where a spring has collapsed
  const auto falls = [&](double alpha, double change) {
    q_ = p - alpha * x_;
    return objective_change(problem.step(), p, q_) < change;
  };
  if (!backtrack(slope, falls) || q_ == p) return Descent::ended;
  p.swap(q_);
  evaluate(problem, p);
  return Descent::moved;
}

}  // namespace mass_spring
