#include "linear_span.h"

#include <doctest/doctest.h>

#include "types.h"
#include "wide_point.h"

namespace mass_spring {
namespace {

/// Entries from -4 to 4, other ones for another seed: their products and sums are exact in floats.
template <typename Field>
Field small_integers(int rows, int seed) {
  Field field(rows, Field::ColsAtCompileTime);
  for (int i = 0; i < field.size(); ++i) {
    field.data()[i] = static_cast<typename Field::Scalar>((i * (seed + 2) + seed) % 9 - 4);
  }
  return field;
}

}  // namespace

TEST_CASE_TEMPLATE("products and combinations take every coordinate once, whatever the shape",
                   Field, Points, WidePoints, RoughPoints) {
  for (int rows = 0; rows < 20; ++rows) {
    CAPTURE(rows);
    const Field a = small_integers<Field>(rows, 1), b = small_integers<Field>(rows, 2);
    const Field g = small_integers<Field>(rows, 3);
    LinearSpan<Field, 3> span;
    span.add(a);
    span.add(b);
    const auto products = span.products(g);
    REQUIRE(products.size() == 2);
    CHECK(products(0) == a.cwiseProduct(g).sum());
    CHECK(products(1) == b.cwiseProduct(g).sum());
    typename LinearSpan<Field, 3>::Numbers coefficients(2);
    coefficients << 3, -0.5;
    Field x(rows, Field::ColsAtCompileTime);
    span.combine(coefficients, x);
    CHECK(x == 3 * a - b / 2);
  }
}

TEST_CASE("sums of many floats are as good as those of doubles") {
  // Within a chunk of 16 products a float loses 1e-7 of a term; added up in floats, a million
  // ones and a half would be off by thousands.
  const RoughPoints a = RoughPoints::Constant(500000, 4, 0.1f);
  LinearSpan<RoughPoints, 1> span;
  span.add(a);
  CHECK(span.products(a)(0) == doctest::Approx(20000).epsilon(1e-6));
}

}  // namespace mass_spring
