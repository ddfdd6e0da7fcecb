#include "dV_gravity_particle_dq.h"

namespace mass_spring {

Eigen::Vector3d dV_gravity_particle_dq(double m, const Eigen::Vector3d& g) { return -m * g; }

}  // namespace mass_spring
