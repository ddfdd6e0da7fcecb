#include "damping_energy.h"

#include "spring_direction.h"

namespace mass_spring {
namespace {

/// Calls of_spring(i, j, n) for every dashpot.
template <typename OfSpring>
void for_dashpots(const TimeStep& step, OfSpring of_spring) {
  if (step.damping == 0) return;
  for (int e = 0; e < step.E.rows(); ++e) {
    const int i = step.E(e, 0), j = step.E(e, 1);
    of_spring(i, j, spring_direction(step.p_curr.row(i), step.p_curr.row(j)));
  }
}

/// m: how much longer the spring is at p than at q, along n.
double lengthening(const Points& p, const Points& q, int i, int j, const Eigen::Vector3d& n) {
  return ((p.row(i) - q.row(i)) - (p.row(j) - q.row(j))) * n;
}

}  // namespace

double damping_energy(const TimeStep& step, const Points& p) {
  double sum = 0;  // m²
  for_dashpots(step, [&](int i, int j, const Eigen::Vector3d& n) {
    const double s = lengthening(p, step.p_curr, i, j, n);
    sum += s * s;
  });
  return 0.5 * step.damping / step.delta_t * sum;
}

void add_damping_gradient(const TimeStep& step, const Points& p, Points& g) {
  for_dashpots(step, [&](int i, int j, const Eigen::Vector3d& n) {
    const Eigen::RowVector3d force =
        step.damping / step.delta_t * lengthening(p, step.p_curr, i, j, n) * n.transpose();
    g.row(i) += force;
    g.row(j) -= force;
  });
}

double damping_energy_change(const TimeStep& step, const Points& p, const Points& q) {
  double sum = 0;  // m²
  for_dashpots(step, [&](int i, int j, const Eigen::Vector3d& n) {
    sum += lengthening(q, p, i, j, n) *
           (lengthening(p, step.p_curr, i, j, n) + lengthening(q, step.p_curr, i, j, n));
  });
  return 0.5 * step.damping / step.delta_t * sum;
}

}  // namespace mass_spring
