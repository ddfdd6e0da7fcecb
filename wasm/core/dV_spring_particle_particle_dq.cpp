#include "dV_spring_particle_particle_dq.h"

#include "spring_direction.h"

namespace mass_spring {

Eigen::Matrix<double, 6, 1> dV_spring_particle_particle_dq(const Eigen::Vector3d& q0,
                                                           const Eigen::Vector3d& q1, double l0,
                                                           double k) {
  const double l = (q0 - q1).norm();
  const Eigen::Vector3d pull = k * (l - l0) * spring_direction(q0, q1);
  Eigen::Matrix<double, 6, 1> dV;
  dV << pull, -pull;
  return dV;
}

}  // namespace mass_spring
