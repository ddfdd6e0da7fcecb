#pragma once

#include <Eigen/Core>

namespace mass_spring {

/// ∂/∂q of V_gravity_particle, N: the weight with its sign turned. [V] "Forces"
/// @param m  kg
/// @param g  m/s²
Eigen::Vector3d dV_gravity_particle_dq(double m, const Eigen::Vector3d& g);

}  // namespace mass_spring
