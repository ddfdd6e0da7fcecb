#include "V_gravity_particle.h"

namespace mass_spring {

double V_gravity_particle(const Eigen::Vector3d& q, double m, const Eigen::Vector3d& g) {
  return -m * g.dot(q);
}

}  // namespace mass_spring
