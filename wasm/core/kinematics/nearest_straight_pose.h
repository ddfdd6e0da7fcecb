#pragma once

#include <optional>

#include "chain.h"

namespace kinematics {

/// Where no pose reaches the target, the joints of the one that comes nearest: stretched towards a
/// target that is too far; folded, the longest link against all others, over one that is too near.
/// @return  #joints, m; nothing where the target can be reached
template <typename Scalar>
std::optional<std::vector<typename Chain<Scalar>::Vector3>> nearest_straight_pose(
    const Chain<Scalar>& chain, const typename Chain<Scalar>::Vector3& target);

}  // namespace kinematics
