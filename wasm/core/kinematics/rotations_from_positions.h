#pragma once

#include "chain.h"

namespace kinematics {

/// Turns every joint by the smallest rotation that makes its link point from x_i to x_{i+1}; what
/// it was twisted by stays. [P] "FABRIK"
/// @param x     #joints, m, as far apart as the links are long
/// @param pose  whose q to start from (updated)
template <typename Scalar>
void rotations_from_positions(const Chain<Scalar>& chain,
                              const std::vector<typename Chain<Scalar>::Vector3>& x,
                              Pose<Scalar>& pose);

}  // namespace kinematics
