#include "dashpot_resistance.h"

#include "spring_direction.h"

namespace mass_spring {

Eigen::Matrix3d dashpot_resistance(const Eigen::Vector3d& q0, const Eigen::Vector3d& q1,
                                   double damping) {
  const Eigen::Vector3d n = spring_direction(q0, q1);
  const Eigen::Matrix3d nnT = n * n.transpose();
  return damping * nnT;  // in two steps, which makes it symmetric to the last bit
}

}  // namespace mass_spring
