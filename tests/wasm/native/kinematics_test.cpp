#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "forward_kinematics.h"
#include "inverse_kinematics_ccd.h"
#include "inverse_kinematics_fabrik.h"
#include "inverse_kinematics_least_squares.h"
#include "joint_limits.h"
#include "nearest_straight_pose.h"
#include "rotation_between.h"
#include "rotations_from_positions.h"

namespace kinematics {
namespace {

using Eigen::AngleAxisd;
using Eigen::Quaterniond;
using Eigen::Vector3d;

constexpr double pi = no_limit;

/// The lab's chain.
Chain<double> lab_chain() {
  Chain<double> chain;
  chain.root = {0, 1.7, 0};
  for (const double length : {0.8, 0.4, 0.2, 1.2}) chain.offsets.push_back({0, -length, 0});
  return chain;
}

Vector3d random_vector(std::mt19937& random) {
  std::uniform_real_distribution<double> coordinate(-1, 1);
  return {coordinate(random), coordinate(random), coordinate(random)};
}

Pose<double> random_pose(const Chain<double>& chain, std::mt19937& random) {
  Pose<double> pose = rest_pose(chain);
  for (auto& q : pose.q) {
    q = Quaterniond(AngleAxisd(3 * random_vector(random).x(), random_vector(random).normalized()));
  }
  forward_kinematics(chain, 0, pose);
  return pose;
}

TEST_CASE("forward kinematics by hand: a quarter turn at the root, and one back at the elbow") {
  Chain<double> chain;
  chain.root = {1, 2, 3};
  chain.offsets = {{0, -1, 0}, {0, -2, 0}};
  Pose<double> pose = rest_pose(chain);
  CHECK(pose.x[2] == Vector3d(1, -1, 3));
  pose.q[0] = AngleAxisd(pi / 2, Vector3d::UnitZ());  // down becomes right
  forward_kinematics(chain, 0, pose);
  CHECK((pose.x[1] - Vector3d(2, 2, 3)).norm() < 1e-15);
  CHECK((pose.x[2] - Vector3d(4, 2, 3)).norm() < 1e-15);
  pose.q[1] = AngleAxisd(-pi / 2, Vector3d::UnitZ());
  forward_kinematics(chain, 1, pose);
  CHECK((pose.x[1] - Vector3d(2, 2, 3)).norm() < 1e-15);
  CHECK((pose.x[2] - Vector3d(2, 0, 3)).norm() < 1e-15);
}

TEST_CASE("forward kinematics is the product of the joints' 4 by 4 matrices") {
  const Chain<double> chain = lab_chain();
  std::mt19937 random(1);
  for (int trial = 0; trial < 100; ++trial) {
    const Pose<double> pose = random_pose(chain, random);
    Eigen::Affine3d product(Eigen::Translation3d(chain.root));
    for (int i = 0; i + 1 < chain.joints(); ++i) {
      product = product * pose.q[i] * Eigen::Translation3d(chain.offsets[i]);
      CHECK((product.translation() - pose.x[i + 1]).norm() < 1e-14);  // m, of some: rounding
      CHECK((product.linear() - pose.R[i].toRotationMatrix()).norm() < 1e-14);
    }
  }
}

TEST_CASE("the rotation between two vectors turns one into the other, by the angle between them") {
  std::mt19937 random(2);
  for (int trial = 0; trial < 100; ++trial) {
    const Vector3d a = random_vector(random), b = random_vector(random);
    const Quaterniond q = rotation_between<double>(a, b);
    CHECK((q * a.normalized() - b.normalized()).norm() < 1e-14);
    const double angle = std::atan2(a.cross(b).norm(), a.dot(b));
    CHECK(std::abs(q.angularDistance(Quaterniond::Identity()) - angle) < 1e-7);
  }
  const Vector3d a(0.3, -2, 0.7);
  CHECK((rotation_between<double>(a, -a) * a + a).norm() < 1e-14);
  CHECK(rotation_between<double>(a, Vector3d::Zero()).isApprox(Quaterniond::Identity()));
}

TEST_CASE("of two directions 1e-4 rad apart single precision knows no rotation, double does") {
  const double angle = 1e-4;
  const Vector3d a = Vector3d::UnitX(), b(std::cos(angle), std::sin(angle), 0);
  const Eigen::Vector3f a_float = a.cast<float>(), b_float = b.cast<float>();
  CHECK(rotation_between<float>(a_float, b_float).vec().norm() == 0);
  CHECK(std::abs(2 * rotation_between<double>(a, b).vec().norm() - angle) < 1e-12);
}

TEST_CASE("rotations are found again from the positions that they make") {
  const Chain<double> chain = lab_chain();
  std::mt19937 random(3);
  for (int trial = 0; trial < 100; ++trial) {
    const Pose<double> pose = random_pose(chain, random);
    Pose<double> found = rest_pose(chain);
    rotations_from_positions(chain, pose.x, found);
    for (int i = 0; i < chain.joints(); ++i) CHECK((found.x[i] - pose.x[i]).norm() < 1e-13);
  }
}

TEST_CASE(
    "the nearest pose is straight beyond the reach, and folded where the longest link is too "
    "long") {
  const Chain<double> chain = lab_chain();
  CHECK_FALSE(nearest_straight_pose(chain, Vector3d(0.6, 0, 0)));
  const auto stretched = nearest_straight_pose(chain, Vector3d(5, 1.7, 0));
  REQUIRE(stretched);
  CHECK((stretched->back() - Vector3d(2.6, 1.7, 0)).norm() < 1e-15);
  Chain<double> long_link = chain;
  long_link.offsets = {{0, -0.3, 0}, {0, -2, 0}, {0, -0.5, 0}};
  const auto folded = nearest_straight_pose(long_link, Vector3d(0.1, 1.7, 0));
  REQUIRE(folded);
  CHECK(std::abs((folded->back() - long_link.root).norm() - 1.2) < 1e-15);  // 2 - 0.3 - 0.5
}

TEST_CASE("held rotations obey both limits, and those within them stay as they are") {
  const Chain<double> chain = lab_chain();
  std::mt19937 random(4);
  const Pose<double> start = rest_pose(chain);
  Settings settings;
  settings.turn_limit = 0.4;
  settings.bend_limits = {0.1, 0.3, 0.5, 1};
  const JointLimits<double> limits(chain, start, settings);
  for (int trial = 0; trial < 100; ++trial) {
    Pose<double> pose = random_pose(chain, random);
    limits.hold(pose);
    for (int i = 0; i + 1 < chain.joints(); ++i) {
      const Vector3d rest = chain.offsets[i], link = pose.q[i] * rest;
      CHECK(std::atan2(rest.cross(link).norm(), rest.dot(link)) < settings.bend_limits[i] + 1e-14);
      CHECK(start.q[i].angularDistance(pose.q[i]) < settings.turn_limit + 1e-7);
      CHECK(limits.hold(i, pose.q[i]).isApprox(pose.q[i], 1e-14));
    }
  }
}

/// All methods in both precisions, from anywhere to anywhere, with and without limits: what
/// sanitizers see of them.
template <typename Scalar>
void search_everywhere() {
  using Vector3 = typename Chain<Scalar>::Vector3;
  const Chain<double> lab = lab_chain();
  Chain<Scalar> chain;
  chain.root = lab.root.cast<Scalar>();
  for (const auto& offset : lab.offsets) chain.offsets.push_back(offset.template cast<Scalar>());
  std::mt19937 random(5);
  for (int trial = 0; trial < 30; ++trial) {
    Pose<Scalar> start = rest_pose(chain);
    const Pose<double> anywhere = random_pose(lab, random);
    for (int i = 0; i < chain.joints(); ++i) start.q[i] = anywhere.q[i].cast<Scalar>();
    forward_kinematics(chain, 0, start);
    const Vector3 target = (lab.root + 2 * random_vector(random)).template cast<Scalar>();
    Settings settings;
    if (trial % 3 == 1) settings.turn_limit = 0.1;
    if (trial % 3 == 2) settings.bend_limits = {1, 1, 1, 1};
    for (const auto method : {inverse_kinematics_ccd<Scalar>, inverse_kinematics_fabrik<Scalar>,
                              inverse_kinematics_least_squares<Scalar>}) {
      const Solution<Scalar> solution = method(chain, start, target, settings);
      CHECK(solution.errors.size() == static_cast<std::size_t>(solution.iterations));
      for (int i = 0; i + 1 < chain.joints(); ++i) {
        const Scalar length = (solution.pose.x[i + 1] - solution.pose.x[i]).norm();
        const Scalar rounding = 16 * std::numeric_limits<Scalar>::epsilon();
        CHECK(std::abs(length - chain.offsets[i].norm()) < rounding);
      }
      const bool near = (solution.pose.effector() - target).norm() <= settings.epsilon;
      CHECK(near == (solution.outcome == Outcome::converged));
    }
  }
}

TEST_CASE("every search keeps the links' lengths, and CONVERGED means within epsilon") {
  search_everywhere<double>();
  search_everywhere<float>();
}

}  // namespace
}  // namespace kinematics
