#include "local_step.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "edge_lengths.h"

namespace mass_spring {
namespace {

/// The projection of one spring from the origin to x, of rest length r.
Eigen::RowVector3d projection(const Eigen::RowVector3d& x, double r) {
  Edges E(1, 2);
  E << 0, 1;
  Points p(2, 3), d;
  p << x, 0, 0, 0;
  local_step(E, Vector::Constant(1, r), p, d);
  return d.row(0);
}

}  // namespace

TEST_CASE("a spring keeps its direction and gets its rest length") {
  // A 3-4-5 triangle, brought from length 5 to 10; powers of two apart, hence exact.
  CHECK(projection({3, 4, 0}, 10) == Eigen::RowVector3d(6, 8, 0));
  CHECK(projection({0, 0, -2}, 1) == Eigen::RowVector3d(0, 0, -1));
}

TEST_CASE("a collapsed spring points along +x") {
  CHECK(projection({0, 0, 0}, 2) == Eigen::RowVector3d(2, 0, 0));
  CHECK(projection({0, 1e-200, 0}, 2) == Eigen::RowVector3d(2, 0, 0));
}

TEST_CASE("a spring of rest length zero projects to nothing") {
  CHECK(projection({3, 4, 0}, 0) == Eigen::RowVector3d(0, 0, 0));
  CHECK(projection({0, 0, 0}, 0) == Eigen::RowVector3d(0, 0, 0));
}

TEST_CASE("not-a-number is passed on, not hidden behind a direction") {
  CHECK(std::isnan(projection({std::numeric_limits<double>::quiet_NaN(), 0, 0}, 1)(0)));
}

TEST_CASE("edge lengths") {
  Points V(3, 3);
  V << 0, 0, 0, 3, 0, 0, 3, 4, 12;
  Edges E(3, 2);
  E << 0, 1, 1, 0, 2, 0;
  Vector r;
  edge_lengths(V, E, r);
  CHECK(r == Vector(Eigen::Vector3d(3, 3, 13)));
}

}  // namespace mass_spring
