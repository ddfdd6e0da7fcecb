#include <doctest/doctest.h>

#include <cmath>

#include "bounding_box_diagonal.h"
#include "gravity.h"
#include "wind.h"

namespace mass_spring {

TEST_CASE("gravity is an acceleration") {
  Points f_ext;
  gravity(Eigen::Vector2d(1, 3), 9.8, f_ext);
  CHECK(f_ext.row(0) == Eigen::RowVector3d(0, -9.8, 0));
  CHECK(f_ext.row(1) == Eigen::RowVector3d(0, -9.8 * 3, 0));
}

TEST_CASE("wind adds an acceleration whose phase runs with x and time") {
  Points p(2, 3), f_ext = Points::Zero(2, 3);
  p << 0, 9, 9, 4, 0, 0;
  wind(Eigen::Vector2d(1, 2), 8, 0.25, p, f_ext);
  // φ = 0/8 + 0.25 and 4/8 + 0.25
  const auto acceleration = [](double phase) {
    return Eigen::RowVector3d(4.5 + 1.5 * std::cos(5 * phase), std::cos(0.3 + phase),
                              std::sin(phase));
  };
  CHECK(f_ext.row(0).isApprox(acceleration(0.25), 1e-15));
  CHECK(f_ext.row(1).isApprox(2 * acceleration(0.75), 1e-15));
}

TEST_CASE("a scene without extent still has wind") {
  Points p = Points::Zero(1, 3), f_ext = Points::Zero(1, 3);
  CHECK(bounding_box_diagonal(p) == 0);
  wind(Vector::Ones(1), 0, 0, p, f_ext);
  CHECK(f_ext.row(0).isApprox(Eigen::RowVector3d(6, std::cos(0.3), 0), 1e-15));
}

TEST_CASE("the diagonal of the bounding box") {
  Points V(3, 3);
  V << 0, 0, 0, 3, -1, 0, 1, 3, 12;
  CHECK(bounding_box_diagonal(V) == 13);
}

}  // namespace mass_spring
