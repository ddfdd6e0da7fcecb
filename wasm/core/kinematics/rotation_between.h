#pragma once

#include <Eigen/Geometry>

namespace kinematics {

/// The smallest rotation that turns the direction of a into that of b; half a turn about some axis
/// across a where they are opposite, and none where one of them is 0.
///
/// Of floats the angle comes from its cosine, as graphics libraries do it: where that is within
/// rounding of 1, which is so below about 5e-4 rad, there is no rotation at all. It is the trap
/// that the lab's report fell into, and what "single precision" stands for here.
template <typename Scalar>
Eigen::Quaternion<Scalar> rotation_between(const Eigen::Matrix<Scalar, 3, 1>& a,
                                           const Eigen::Matrix<Scalar, 3, 1>& b);

}  // namespace kinematics
