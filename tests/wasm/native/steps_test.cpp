#include "steps.h"

#include <doctest/doctest.h>

#include <vector>

#include "types.h"

namespace mass_spring {
namespace {

using TwoSteps = Steps<Points, 2>;

/// h and s of the k-th iterate are the numbers 10 k + 1 and 10 k + 2.
TwoSteps after(int iterates) {
  TwoSteps steps;
  steps.begin(Points(1, 3));
  for (int k = 0; k < iterates; ++k) {
    steps.h().setConstant(10 * k + 1);
    steps.s().setConstant(10 * k + 2);
    steps.advance();
  }
  steps.h().setConstant(10 * iterates + 1);
  return steps;
}

/// The numbers of a span, in its order.
std::vector<double> numbers(const TwoSteps::Span& span) {
  Points first(1, 3);
  first << 1, 0, 0;
  const auto products = span.products(first);
  return {products.begin(), products.end()};
}

}  // namespace

TEST_CASE("every h comes before every s, the oldest first, and older ones are forgotten") {
  CHECK(numbers(after(0).every_h_and_s()) == std::vector<double>{1});
  CHECK(numbers(after(1).every_h_and_s()) == std::vector<double>{1, 11, 2});
  CHECK(numbers(after(2).every_h_and_s()) == std::vector<double>{1, 11, 21, 2, 12});
  CHECK(numbers(after(4).every_h_and_s()) == std::vector<double>{21, 31, 41, 22, 32});
  CHECK(numbers(after(4).every_h()) == std::vector<double>{21, 31, 41});
  CHECK(after(4).count() == 2);
}

TEST_CASE("the present iterate outlasts how it was reached") {
  TwoSteps steps = after(4);
  steps.forget();
  CHECK(steps.count() == 0);
  CHECK(numbers(steps.every_h_and_s()) == std::vector<double>{41});
}

}  // namespace mass_spring
