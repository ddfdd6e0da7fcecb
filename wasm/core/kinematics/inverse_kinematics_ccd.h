#pragma once

#include "solution.h"

namespace kinematics {

/// Cyclic coordinate descent: from the last joint to the root, each turns in its own frame so that
/// its ray to the end effector points at the target. One iteration is one turn of all joints.
/// [P] "CCD"
/// @param start   the pose to begin with
/// @param target  m
template <typename Scalar>
Solution<Scalar> inverse_kinematics_ccd(const Chain<Scalar>& chain, const Pose<Scalar>& start,
                                        const typename Chain<Scalar>::Vector3& target,
                                        const Settings& settings);

}  // namespace kinematics
