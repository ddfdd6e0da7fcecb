#include "spring_direction.h"

namespace mass_spring {

Eigen::Vector3d spring_direction(const Eigen::Vector3d& q0, const Eigen::Vector3d& q1) {
  const Eigen::Vector3d x = q0 - q1;
  const double l = x.norm();
  if (l < collapsed_length) return Eigen::Vector3d::UnitX();
  return x / l;
}

}  // namespace mass_spring
