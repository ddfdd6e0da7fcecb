#pragma once

#include <Eigen/Core>

namespace mass_spring {

/// m: squares of shorter lengths underflow, so that their direction is lost.
constexpr double collapsed_length = 1e-150;

/// (q0 - q1)/|q0 - q1|; where the spring has collapsed +x, as in local_step.
/// @param q0  m
/// @param q1  m
Eigen::Vector3d spring_direction(const Eigen::Vector3d& q0, const Eigen::Vector3d& q1);

}  // namespace mass_spring
