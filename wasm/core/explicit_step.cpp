#include "explicit_step.h"

#include "edge_vectors.h"
#include "inertial_prediction.h"
#include "local_step.h"

namespace mass_spring {

Points explicit_step(const TimeStep& step) {
  Points x, d;  // #E by 3, m
  edge_vectors(step.E, step.p_curr, x);
  local_step(step.E, step.r, step.p_curr, d);
  Points p = inertial_prediction(step);
  const Vector mobility = step.delta_t * step.delta_t / step.m.array();  // #V, m/N
  for (int e = 0; e < step.E.rows(); ++e) {
    const int i = step.E(e, 0), j = step.E(e, 1);
    const Eigen::RowVector3d force = -step.k * (x.row(e) - d.row(e));  // N, at i
    p.row(i) += mobility(i) * force;
    p.row(j) -= mobility(j) * force;
  }
  for (int c = 0; c < step.pinned.size(); ++c) p.row(step.pinned(c)) = step.targets.row(c);
  return p;
}

}  // namespace mass_spring
