#pragma once

#include "chain.h"

namespace kinematics {

/// R_i = R_{i-1} q_i,  x_i = x_{i-1} + R_{i-1} o_i  with R_0 = q_0 and x_0 the root, from joint
/// `start` on; what lies before is taken as it is. [P] "Forward kinematics"
/// @param pose  q is read; R and x are computed (updated)
template <typename Scalar>
void forward_kinematics(const Chain<Scalar>& chain, int start, Pose<Scalar>& pose);

/// The pose in which nothing turns.
template <typename Scalar>
Pose<Scalar> rest_pose(const Chain<Scalar>& chain);

}  // namespace kinematics
