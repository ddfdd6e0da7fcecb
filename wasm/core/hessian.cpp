#include "hessian.h"

#include "spring_direction.h"

namespace mass_spring {

void hessian(const TimeStep& step, const Points& p, double left_out, SpringBlocks& H) {
  H.set_zero();
  for (int e = 0; e < step.E.rows(); ++e) {
    const int i = step.E(e, 0), j = step.E(e, 1);
    const Eigen::Vector3d n = spring_direction(p.row(i), p.row(j));
    double across = step.r(e) == 0 ? 1 : 1 - step.r(e) / (p.row(i) - p.row(j)).norm();
    if (across < 0) across = left_out == 1 ? 0 : (1 - left_out) * across;
    const Eigen::Matrix3d nnT = n * n.transpose();
    Eigen::Matrix3d block = step.k * (nnT + across * (Eigen::Matrix3d::Identity() - nnT));
    if (step.damping > 0) {
      const Eigen::Vector3d at_start = spring_direction(step.p_curr.row(i), step.p_curr.row(j));
      block += step.damping / step.delta_t * at_start * at_start.transpose();
    }
    H.add_spring(e, block);
  }
  for (int i = 0; i < step.m.size(); ++i) {
    H.add_vertex(i, step.m(i) / (step.delta_t * step.delta_t));
  }
  for (const int i : step.pinned) H.add_vertex(i, step.w);
  for (const int i : step.pull.vertices) H.add_vertex(i, step.pull.k);
}

}  // namespace mass_spring
