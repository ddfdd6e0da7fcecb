#pragma once

#include "solution.h"

namespace kinematics {

/// Forward and backward reaching: backward, the end effector is put on the target and pulls the
/// joints along at their links' lengths; forward, the root is put back and pulls them the other
/// way. The rotations follow from the positions. One iteration is both passes. [P] "FABRIK"
/// @param start   the pose to begin with
/// @param target  m
template <typename Scalar>
Solution<Scalar> inverse_kinematics_fabrik(const Chain<Scalar>& chain, const Pose<Scalar>& start,
                                           const typename Chain<Scalar>::Vector3& target,
                                           const Settings& settings);

}  // namespace kinematics
