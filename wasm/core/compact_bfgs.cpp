#include "compact_bfgs.h"

#include <algorithm>

namespace mass_spring {

bool CompactBfgs::arrive(const Numbers& products) {
  const int n = pairs_;
  const Numbers hg = products.head(n + 1), sg = products.tail(n);
  if (n > 0) {
    // Products with y = g - g_before, where h·g_before = h_before·g.
    Numbers hy = hg;
    hy.head(n) -= hg_.head(n);
    hy(n) -= hg(n - 1);
    R_.col(n - 1).head(n) = sg - sg_.head(n);
    YtZ_.col(n - 1).head(n) = hy.tail(n) - hy.head(n);
    YtZ_.row(n - 1).head(n) = YtZ_.col(n - 1).head(n).transpose();
  }
  hg_.head(n + 1) = hg;
  sg_.head(n) = sg;
  return n == 0 || R_(n - 1, n - 1) > 0;
}

CompactBfgs::Numbers CompactBfgs::coefficients() const {
  const int n = pairs_;
  const auto R = R_.topLeftCorner(n, n);
  const auto YtZ = YtZ_.topLeftCorner(n, n);
  const double gamma = n > 0 ? R_(n - 1, n - 1) / YtZ_(n - 1, n - 1) : 1;
  const Numbers Ztg = hg_.segment(1, n) - hg_.head(n);
  const Numbers a = R.triangularView<Eigen::Upper>().solve(sg_.head(n));
  Numbers u = R.diagonal().cwiseProduct(a) + gamma * (YtZ * a - Ztg);
  R.transpose().triangularView<Eigen::Lower>().solveInPlace(u);
  // γ(h - Z a) in terms of every h, a column of Z being the difference of two.
  Numbers coefficients = Numbers::Zero(2 * n + 1);
  coefficients(n) = gamma;
  coefficients.head(n) += gamma * a;
  coefficients.segment(1, n) -= gamma * a;
  coefficients.tail(n) = u;
  return coefficients;
}

double CompactBfgs::slope(const Numbers& coefficients) const {
  return coefficients.head(pairs_ + 1).dot(hg_.head(pairs_ + 1)) +
         coefficients.tail(pairs_).dot(sg_.head(pairs_));
}

void CompactBfgs::depart(double sg) {
  sg_(pairs_) = sg;
  if (pairs_ < window) {
    ++pairs_;
    return;
  }
  std::rotate(hg_.begin(), hg_.begin() + 1, hg_.end());
  std::rotate(sg_.begin(), sg_.begin() + 1, sg_.end());
  constexpr int left = window - 1;
  R_.topLeftCorner<left, left>() = R_.bottomRightCorner<left, left>().eval();
  YtZ_.topLeftCorner<left, left>() = YtZ_.bottomRightCorner<left, left>().eval();
}

void CompactBfgs::forget_pairs() {
  hg_(0) = hg_(pairs_);
  pairs_ = 0;
}

}  // namespace mass_spring
