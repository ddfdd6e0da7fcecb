#include "V_spring_particle_particle.h"

namespace mass_spring {

double V_spring_particle_particle(const Eigen::Vector3d& q0, const Eigen::Vector3d& q1, double l0,
                                  double k) {
  const double stretch = (q0 - q1).norm() - l0;  // m
  return 0.5 * k * stretch * stretch;
}

}  // namespace mass_spring
