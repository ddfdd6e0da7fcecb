#pragma once

#include <Eigen/Core>

namespace mass_spring {

/// C n nᵀ, N s/m, n the spring_direction: how the dashpot beside a spring resists the velocity of
/// its ends against each other.
/// @param q0       m
/// @param q1       m
/// @param damping  c, N s/m
Eigen::Matrix3d dashpot_resistance(const Eigen::Vector3d& q0, const Eigen::Vector3d& q1,
                                   double damping);

}  // namespace mass_spring
