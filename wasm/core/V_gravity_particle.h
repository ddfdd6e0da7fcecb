#pragma once

#include <Eigen/Core>

namespace mass_spring {

/// Potential energy -m gᵀq of a particle where the acceleration is g, J. [V] "Potential energy"
/// @param q  m
/// @param m  kg
/// @param g  m/s²
double V_gravity_particle(const Eigen::Vector3d& q, double m, const Eigen::Vector3d& g);

}  // namespace mass_spring
