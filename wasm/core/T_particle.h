#pragma once

#include <Eigen/Core>

namespace mass_spring {

/// Kinetic energy ½ m |q̇|², J. [V] "Kinetic energy"
/// @param q_dot  m/s
/// @param m      kg
double T_particle(const Eigen::Vector3d& q_dot, double m);

}  // namespace mass_spring
