#include "d2V_spring_particle_particle_dq2.h"

#include <cmath>

#include "spring_direction.h"

namespace mass_spring {

Eigen::Matrix<double, 6, 6> d2V_spring_particle_particle_dq2(const Eigen::Vector3d& q0,
                                                             const Eigen::Vector3d& q1, double l0,
                                                             double k) {
  const double l = (q0 - q1).norm();
  const Eigen::Vector3d n = spring_direction(q0, q1);
  double across = l0 == 0 ? 1 : 1 - l0 / l;
  if (!std::isfinite(across)) across = 0;
  const Eigen::Matrix3d nnT = n * n.transpose();
  const Eigen::Matrix3d H_e = k * (nnT + across * (Eigen::Matrix3d::Identity() - nnT));
  Eigen::Matrix<double, 6, 6> d2V;
  d2V << H_e, -H_e, -H_e, H_e;
  return d2V;
}

}  // namespace mass_spring
