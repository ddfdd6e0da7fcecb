#pragma once

#include <Eigen/Core>

namespace mass_spring {

/// Potential energy ½k(|q0 - q1| - l0)² of a spring between two particles, J. [V] "Potential
/// energy"
/// @param q0  m
/// @param q1  m
/// @param l0  m: its rest length
/// @param k   N/m
double V_spring_particle_particle(const Eigen::Vector3d& q0, const Eigen::Vector3d& q1, double l0,
                                  double k);

}  // namespace mass_spring
