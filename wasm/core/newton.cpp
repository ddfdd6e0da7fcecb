#include "newton.h"

#include <array>
#include <limits>
#include <vector>

#include "backtrack.h"
#include "gradient.h"
#include "hessian.h"
#include "inner_product.h"
#include "matrix_from_triplets.h"
#include "objective.h"
#include "objective_change.h"

namespace mass_spring {
namespace {

constexpr std::array<double, 6> shares_left_out = {0, 1.0 / 256, 1.0 / 64, 1.0 / 16, 1.0 / 4, 1};

/// The rows and columns of held vertices become those of the identity: they do not move.
Triplets without_held(const Triplets& H, const Indices& pinned, int n) {
  std::vector<bool> held(n, false);
  for (const int i : pinned) held[i] = true;
  Triplets free;
  free.reserve(H.size());
  for (const auto& entry : H) {
    if (!held[entry.row() / 3] && !held[entry.col() / 3]) free.push_back(entry);
  }
  for (const int i : pinned) {
    for (int c = 0; c < 3; ++c) free.emplace_back(3 * i + c, 3 * i + c, 1);
  }
  return free;
}

// Moves of the last digit of p are rounding, and could go on for ever.
constexpr double resolution = 2 * std::numeric_limits<double>::epsilon();

SparseMatrix hessian_matrix(const NewtonProblem& problem, const Points& p, double left_out) {
  const TimeStep& step = problem.step();
  Triplets entries = hessian(step, p, left_out);
  if (problem.holds_pins()) {
    entries = without_held(entries, step.pinned, static_cast<int>(p.rows()));
  }
  const int size = static_cast<int>(p.size());
  SparseMatrix H;
  matrix_from_triplets(size, size, entries, H);
  return H;
}

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
    if (descend(problem, shares_left_out[caution_], p)) return true;
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
bool Newton::descend(const NewtonProblem& problem, double left_out, Points& p) {
  const SparseMatrix H = hessian_matrix(problem, p, left_out);
  if (!analysed_) llt_.analyzePattern(H);
  analysed_ = true;
  llt_.factorize(H);
  if (llt_.info() != Eigen::Success) return false;
  x_.resizeLike(p);
  x_.reshaped<Eigen::RowMajor>() = llt_.solve(standing_.gradient.reshaped<Eigen::RowMajor>());
  ++standing_.solves;
  if (x_.cwiseAbs().maxCoeff() <= resolution * p.cwiseAbs().maxCoeff()) return false;
  const double slope = -inner_product(x_, standing_.gradient);
  if (!(slope < 0)) return false;  // not-a-number where a spring has collapsed
  const auto falls = [&](double alpha, double change) {
    q_ = p - alpha * x_;
    return objective_change(problem.step(), p, q_) < change;
  };
  if (!backtrack(slope, falls) || q_ == p) return false;
  p.swap(q_);
  evaluate(problem, p);
  return true;
}

}  // namespace mass_spring
