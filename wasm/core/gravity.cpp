#include "gravity.h"

#include "dV_gravity_particle_dq.h"

namespace mass_spring {

void gravity(const Vector& m, double acceleration, Points& f_ext) {
  const Eigen::Vector3d g(0, -acceleration, 0);  // m/s²
  f_ext.resize(m.size(), 3);
  for (int i = 0; i < m.size(); ++i) f_ext.row(i) = -dV_gravity_particle_dq(m(i), g);
}

}  // namespace mass_spring
