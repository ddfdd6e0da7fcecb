#pragma once

#include <Eigen/Geometry>
#include <vector>

namespace kinematics {

/// Joints one after the other, each turning all that follow: joint i + 1 is offsets[i] away from
/// joint i as long as nothing turns. The last one is the end effector.
/// @tparam Scalar  double, or float for what single precision makes of it
template <typename Scalar>
struct Chain {
  using Vector3 = Eigen::Matrix<Scalar, 3, 1>;

  Vector3 root;                  // m: x_0
  std::vector<Vector3> offsets;  // #links, m

  int joints() const { return static_cast<int>(offsets.size()) + 1; }
};

/// What a chain looks like. The joints' own rotations determine all else.
template <typename Scalar>
struct Pose {
  using Vector3 = Eigen::Matrix<Scalar, 3, 1>;
  using Quaternion = Eigen::Quaternion<Scalar>;

  std::vector<Quaternion> q;  // #joints: of each joint against the one before
  std::vector<Quaternion> R;  // #joints: of each joint against the world
  std::vector<Vector3> x;     // #joints, m

  const Vector3& effector() const { return x.back(); }
};

}  // namespace kinematics
