#include "least_squares.h"

#include <doctest/doctest.h>

#include "types.h"

namespace mass_spring {
namespace {

Points field(double x, double y, double z) {
  Points points(1, 3);
  points << x, y, z;
  return points;
}

}  // namespace

TEST_CASE("the nearest combination of fields, by hand") {
  // Of the plane z = 0, (4, 3, 0) = ½ (2, 0, 0) + 3 (1, 1, 0) is nearest to (4, 3, 5).
  std::array<Points, 3> a = {field(2, 0, 0), field(1, 1, 0), field(0, 0, 1)};
  Points f = field(4, 3, 5);
  CHECK(least_squares(2, a, f) == std::array<double, 3>{0.5, 3, 0});
  CHECK(f == field(0, 0, 5));
}

TEST_CASE("fields that depend on those before are not used") {
  std::array<Points, 3> a = {field(0, 0, 0), field(3, 4, 0), field(-6, -8, 0)};
  Points f = field(6, 8, 1);
  const auto theta = least_squares(3, a, f);
  CHECK(theta[0] == 0);
  CHECK(theta[1] == doctest::Approx(2).epsilon(1e-15));
  CHECK(theta[2] == 0);
}

TEST_CASE("nearly dependent fields keep half the digits, where the normal equations keep none") {
  // The squares of 1e-8 are lost in 1 + 1e-16.
  std::array<Points, 2> a = {field(1, 1e-8, 0), field(1, 0, 1e-8)};
  Points f = field(2, 1e-8, 1e-8);
  const auto theta = least_squares(2, a, f);
  CHECK(theta[0] == doctest::Approx(1).epsilon(1e-7));
  CHECK(theta[1] == doctest::Approx(1).epsilon(1e-7));
}

TEST_CASE("an inner product takes every entry once, whatever the shape") {
  for (int rows = 0; rows < 6; ++rows) {
    const Points a = Points::Constant(rows, 3, 2), b = Points::Constant(rows, 3, 5);
    CHECK(inner_product(a, b) == 30 * rows);
  }
}

}  // namespace mass_spring
