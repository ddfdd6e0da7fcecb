#include <doctest/doctest.h>

#include <limits>

#include "dense_cholesky.h"
#include "sparse_cholesky.h"

namespace mass_spring {

TEST_CASE_TEMPLATE("Q p = b is solved, again with other values and with another pattern", Cholesky,
                   DenseCholesky, SparseCholesky) {
  Cholesky Q;
  DenseMatrix x;
  Points p, b(2, 3);
  b << 2, 6, 0, 4, 2, 8;
  // [[2 0] [0 4]]
  REQUIRE(Q.factorise(2, {{0, 0, 2.0}, {1, 1, 4.0}}));
  Q.solve(b, x, p);
  Points by_hand(2, 3);
  by_hand << 1, 3, 0, 1, 0.5, 2;
  CHECK(p.isApprox(by_hand, 1e-15));
  // [[1 0] [0 2]]: the pattern is known
  REQUIRE(Q.factorise(2, {{0, 0, 1.0}, {1, 1, 2.0}}));
  Q.solve(b, x, p);
  by_hand << 2, 6, 0, 2, 1, 4;
  CHECK(p.isApprox(by_hand, 1e-15));
  // [[2 -1] [-1 2]], of inverse [[2 1] [1 2]]/3: another pattern
  REQUIRE(Q.factorise(2, {{0, 0, 2.0}, {1, 1, 2.0}, {0, 1, -1.0}, {1, 0, -1.0}}));
  Q.solve(b, x, p);
  by_hand << 8.0 / 3, 14.0 / 3, 8.0 / 3, 10.0 / 3, 10.0 / 3, 16.0 / 3;
  CHECK(p.isApprox(by_hand, 1e-15));
}

TEST_CASE_TEMPLATE("what is not positive definite is refused", Cholesky, DenseCholesky,
                   SparseCholesky) {
  Cholesky Q;
  CHECK_FALSE(Q.factorise(1, {{0, 0, -1.0}}));
  CHECK_FALSE(Q.factorise(2, {{0, 0, 1.0}, {1, 1, 1.0}, {0, 1, -2.0}, {1, 0, -2.0}}));
  // Of these two Eigen says that they succeed.
  CHECK_FALSE(Q.factorise(1, {{0, 0, std::numeric_limits<double>::quiet_NaN()}}));
  CHECK_FALSE(Q.factorise(1, {{0, 0, std::numeric_limits<double>::infinity()}}));
}

}  // namespace mass_spring
