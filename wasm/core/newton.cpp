#include "newton.h"

#include <array>

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

SparseMatrix hessian_matrix(const TimeStep& step, const Points& p, double left_out) {
  const int size = static_cast<int>(p.size());
  SparseMatrix H;
  matrix_from_triplets(size, size, hessian(step, p, left_out), H);
  return H;
}

}  // namespace

void Newton::begin(const TimeStep& step, const Points& p) {
  standing_ = {};
  caution_ = 0;
  evaluate(step, p);
  llt_.analyzePattern(hessian_matrix(step, p, 0));
}

bool Newton::iterate(const TimeStep& step, Points& p) {
  // A little bolder than last time, then ever more cautious.
  if (caution_ > 0) --caution_;
  for (; caution_ < shares_left_out.size(); ++caution_) {
    if (descend(step, shares_left_out[caution_], p)) return true;
  }
  return false;
}

void Newton::evaluate(const TimeStep& step, const Points& p) {
  standing_.objective = objective(step, p).objective;
  gradient(step, p, standing_.gradient);
  ++standing_.gradient_evaluations;
}

/// p ← p - α H⁻¹ ∂E/∂p, if that lowers E.
bool Newton::descend(const TimeStep& step, double left_out, Points& p) {
  llt_.factorize(hessian_matrix(step, p, left_out));
  if (llt_.info() != Eigen::Success) return false;
  x_.resizeLike(p);
  x_.reshaped<Eigen::RowMajor>() = llt_.solve(standing_.gradient.reshaped<Eigen::RowMajor>());
  ++standing_.solves;
  const double slope = -inner_product(x_, standing_.gradient);
  if (!(slope < 0)) return false;  // not-a-number where a spring has collapsed
  const auto falls = [&](double alpha, double change) {
    q_ = p - alpha * x_;
    return objective_change(step, p, q_) < change;
  };
  if (!backtrack(slope, falls) || q_ == p) return false;
  p.swap(q_);
  evaluate(step, p);
  return true;
}

}  // namespace mass_spring
