#include "assemble_forces.h"

#include "dV_spring_particle_particle_dq.h"
#include "spring_direction.h"

namespace mass_spring {

void assemble_forces(const TimeStep& step, const Points& q, const Points& q_dot, Points& f) {
  f = step.f_ext;
  for (int e = 0; e < step.E.rows(); ++e) {
    const int i = step.E(e, 0), j = step.E(e, 1);
    const auto dV = dV_spring_particle_particle_dq(q.row(i), q.row(j), step.r(e), step.k);
    f.row(i) -= dV.head<3>();
    f.row(j) -= dV.tail<3>();
    if (step.damping == 0) continue;
    const Eigen::Vector3d n = spring_direction(q.row(i), q.row(j));
    const double lengthening = (q_dot.row(i) - q_dot.row(j)) * n;  // m/s
    f.row(i) -= step.damping * lengthening * n;
    f.row(j) += step.damping * lengthening * n;
  }
  const Pull& pull = step.pull;
  for (int c = 0; c < pull.vertices.size(); ++c) {
    const int i = pull.vertices(c);
    const auto dV = dV_spring_particle_particle_dq(q.row(i), pull.targets.row(c), 0, pull.k);
    f.row(i) -= dV.head<3>();
  }
}

}  // namespace mass_spring
