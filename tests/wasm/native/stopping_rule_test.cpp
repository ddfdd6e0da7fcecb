#include "stopping_rule.h"

#include <doctest/doctest.h>

#include <vector>

#include "backtrack.h"
#include "types.h"

namespace mass_spring {
namespace {

/// Its objective above `offset` halves from 64 J, and its gradient from 64 N with it; after `most`
/// iterations it cannot move any more.
class Halving : public Minimiser {
 public:
  explicit Halving(int most, double offset = 0) : most_(most), offset_(offset) {}
  double objective() const override { return p_; }
  double objective_offset() const override { return offset_; }
  double gradient_norm() const override { return p_; }
  void positions(Points& p) const override { p.setConstant(1, 3, p_); }

 private:
  void start(const Points& p) override { p_ = p(0, 0); }
  bool advance() override {
    if (most_-- == 0) return false;
    p_ /= 2;
    return true;
  }

  int most_;
  double offset_;  // J
  double p_ = 0;
};

Outcome outcome(const StoppingRule& rule, int most = 1000, double offset = 0) {
  Halving method(most, offset);
  return iterate_until(rule, method, Points::Constant(1, 3, 64));
}

void check(const Outcome& outcome, StopReason reason, int iterations) {
  CHECK(outcome.reason == reason);
  CHECK(outcome.iterations == iterations);
}

}  // namespace

TEST_CASE("without a threshold, after K iterations") {
  check(outcome({5}), StopReason::iterations, 5);
}

TEST_CASE("once no component of the gradient is above the threshold, be it at the start") {
  check(outcome({50, 8.0}), StopReason::gradient, 3);  // 64, 32, 16, 8
  check(outcome({50, 7.9}), StopReason::gradient, 4);
  check(outcome({50, 64.0}), StopReason::gradient, 0);
  check(outcome({3, 7.9}), StopReason::iterations, 3);
}

TEST_CASE("once the objective hardly falls, compared with itself or with 1 J") {
  // The k-th iteration lowers E to 64/2^k by as much: for ε = 1 the first one, by 32 ≤ 1·32.
  check(outcome({50, 0, 1.0}), StopReason::decrease, 1);
  // Below 1 J, from the 7th on to 64/2^k, it falls by 64/2^k ≤ ε = 1/4 first for k = 8.
  check(outcome({50, 0, 0.25}), StopReason::decrease, 8);
  check(outcome({7, 0, 0.25}), StopReason::iterations, 7);
}

TEST_CASE("what is left out of the objective counts where it is compared with itself") {
  // E falls to E₀ + 64/2^k by as much. For ε = 1/8 and E₀ = 120 J: first by 16 ≤ 136/8, for k = 2;
  // for E₀ = -40 J: first by 4 ≤ |-36|/8, for k = 4.
  check(outcome({50, 0, 0.125}, 1000, 120), StopReason::decrease, 2);
  check(outcome({50, 0, 0.125}, 1000, -40), StopReason::decrease, 4);
}

TEST_CASE("where no iteration moves any further") {
  check(outcome({50}, 4), StopReason::rounding, 5);
  check(outcome({50}, 0), StopReason::rounding, 1);
}

TEST_CASE("backtracking takes the first step that lowers E by enough") {
  // E(α) = -α + 4α² J: slope -1, lower than at 0 below α = ¼ only.
  std::vector<double> tried;
  CHECK(backtrack(-1, [&tried](double alpha, double change) {
    tried.push_back(alpha);
    CHECK(change == -1e-4 * alpha);
    return -alpha + 4 * alpha * alpha < change;
  }));
  CHECK(tried == std::vector<double>{1, 0.5, 0.25, 0.125});
  CHECK_FALSE(backtrack(-1, [](double, double) { return false; }));
}

}  // namespace mass_spring
