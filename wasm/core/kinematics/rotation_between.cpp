#include "rotation_between.h"

#include <limits>
#include <type_traits>

namespace kinematics {

template <typename Scalar>
Eigen::Quaternion<Scalar> rotation_between(const Eigen::Matrix<Scalar, 3, 1>& a,
                                           const Eigen::Matrix<Scalar, 3, 1>& b) {
  using Quaternion = Eigen::Quaternion<Scalar>;
  if (a.squaredNorm() == 0 || b.squaredNorm() == 0) return Quaternion::Identity();
  if (std::is_same<Scalar, float>::value) {
    const Scalar cosine = a.normalized().dot(b.normalized());
    if (cosine >= 1 - std::numeric_limits<Scalar>::epsilon()) return Quaternion::Identity();
  }
  // Keeps the sine, the length of a × b, so that small angles keep their digits.
  return Quaternion::FromTwoVectors(a, b).normalized();
}

template Eigen::Quaterniond rotation_between(const Eigen::Vector3d&, const Eigen::Vector3d&);
template Eigen::Quaternionf rotation_between(const Eigen::Vector3f&, const Eigen::Vector3f&);

}  // namespace kinematics
