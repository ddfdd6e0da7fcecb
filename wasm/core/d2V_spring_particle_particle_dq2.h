#pragma once

#include <Eigen/Core>

namespace mass_spring {

/// ∂²/∂(q0, q1)² of V_spring_particle_particle, N/m: with the block
///   H_e = k [n nᵀ + (1 - l0/l)(I - n nᵀ)],  n the spring_direction,
/// on the diagonal and -H_e beside it. A collapsed spring, of which that is infinite across n, gets
/// k n nᵀ. [V] "Linearly implicit time integration"
/// @param q0  m
/// @param q1  m
/// @param l0  m
/// @param k   N/m
Eigen::Matrix<double, 6, 6> d2V_spring_particle_particle_dq2(const Eigen::Vector3d& q0,
                                                             const Eigen::Vector3d& q1, double l0,
                                                             double k);

}  // namespace mass_spring
