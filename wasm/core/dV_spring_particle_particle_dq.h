#pragma once

#include <Eigen/Core>

namespace mass_spring {

/// ∂/∂(q0, q1) of V_spring_particle_particle, N: k(l - l0) n and its opposite, n the
/// spring_direction. [V] "Forces"
/// @param q0  m
/// @param q1  m
/// @param l0  m
/// @param k   N/m
Eigen::Matrix<double, 6, 1> dV_spring_particle_particle_dq(const Eigen::Vector3d& q0,
                                                           const Eigen::Vector3d& q1, double l0,
                                                           double k);

}  // namespace mass_spring
