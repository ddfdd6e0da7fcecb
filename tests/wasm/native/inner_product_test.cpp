#include "inner_product.h"

#include <doctest/doctest.h>

#include "types.h"

namespace mass_spring {

TEST_CASE("an inner product takes every entry once, whatever the shape") {
  for (int rows = 0; rows < 6; ++rows) {
    const Points a = Points::Constant(rows, 3, 2), b = Points::Constant(rows, 3, 5);
    CHECK(inner_product(a, b) == 30 * rows);
  }
}

}  // namespace mass_spring
