#include "T_particle.h"

namespace mass_spring {

double T_particle(const Eigen::Vector3d& q_dot, double m) { return 0.5 * m * q_dot.squaredNorm(); }

}  // namespace mass_spring
