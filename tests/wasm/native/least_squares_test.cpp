#include "least_squares.h"

#include <doctest/doctest.h>

namespace mass_spring {
namespace {

using Numbers = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 3, 1>;

/// The coefficients of the columns of A nearest to f.
Numbers nearest(const Eigen::MatrixXd& A, const Eigen::VectorXd& f) {
  const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 3, 3> G = A.transpose() * A;
  const Numbers c = A.transpose() * f;
  return least_squares(G, c);
}

}  // namespace

TEST_CASE("the nearest combination of vectors, by hand") {
  // Of the plane z = 0, (4, 3, 0) = ½ (2, 0, 0) + 3 (1, 1, 0) is nearest to (4, 3, 5).
  const Eigen::MatrixXd A{{2, 1}, {0, 1}, {0, 0}};
  const Numbers theta = nearest(A, Eigen::Vector3d(4, 3, 5));
  REQUIRE(theta.size() == 2);
  CHECK(theta(0) == 0.5);
  CHECK(theta(1) == 3);
}

TEST_CASE("vectors that depend on those before are not used") {
  const Eigen::MatrixXd A{{0, 3, -6}, {0, 4, -8}, {0, 0, 0}};
  const Numbers theta = nearest(A, Eigen::Vector3d(6, 8, 1));
  CHECK(theta == Numbers(Eigen::Vector3d(0, 2, 0)));
}

TEST_CASE("what is left is orthogonal to every vector") {
  const Eigen::MatrixXd A{{1, 2, -1}, {0, 1, 3}, {2, 0, 1}, {1, 1, 1}, {-1, 0, 2}};
  const Eigen::VectorXd f{{3, 1, 4, 1, 5}};
  // Numbers of about 10, a few roundings each.
  CHECK((A.transpose() * (f - A * nearest(A, f))).cwiseAbs().maxCoeff() < 1e-13);
}

TEST_CASE("vectors that differ by 1e-4 only keep half the digits") {
  // Their squares differ by 1e-8, which products know to eight digits.
  const Eigen::MatrixXd A{{1, 1}, {1e-4, 0}, {0, 1e-4}};
  const Numbers theta = nearest(A, Eigen::Vector3d(2, 1e-4, 1e-4));
  CHECK(theta(0) == doctest::Approx(1).epsilon(1e-7));
  CHECK(theta(1) == doctest::Approx(1).epsilon(1e-7));
}

}  // namespace mass_spring
