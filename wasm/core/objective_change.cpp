#include "objective_change.h"

#include "damping_energy.h"

namespace mass_spring {

/// Σ w (q - p)ᵀ((p + q)/2 - p^target), J
static double held_change(const Indices& held, const Points& targets, double w, const Points& p,
                          const Points& q) {
  double change = 0;
  for (int c = 0; c < held.size(); ++c) {
    const int i = held(c);
    const Eigen::RowVector3d move = q.row(i) - p.row(i), middle = 0.5 * (p.row(i) + q.row(i));
    change += w * move.dot(middle - targets.row(c));
  }
  return change;
}

double objective_change(const TimeStep& step, const Points& p, const Points& q) {
  double change = 0;
  // ½k (|b| - r)² - ½k (|a| - r)² = ½k (|b| - |a|) (|a| + |b| - 2r), |b| - |a| = (b - a)ᵀ(a + b) /
  // (|a| + |b|), where a and b are the spring before and after
  for (int e = 0; e < step.E.rows(); ++e) {
    const int i = step.E(e, 0), j = step.E(e, 1);
    const Eigen::RowVector3d a = p.row(i) - p.row(j), b = q.row(i) - q.row(j);
    const double sum = a.norm() + b.norm();
    if (sum == 0) continue;
    const double lengthening = ((q.row(i) - p.row(i)) - (q.row(j) - p.row(j))).dot(a + b) / sum;
    change += 0.5 * step.k * lengthening * (sum - 2 * step.r(e));
  }
  for (int i = 0; i < step.m.size(); ++i) {
    const Eigen::RowVector3d move = q.row(i) - p.row(i), middle = 0.5 * (p.row(i) + q.row(i));
    // m_i/Δt² (q - p)ᵀ((p + q)/2 - 2p^t + p^{t-Δt}) - (q - p)ᵀ f^ext
    const double inertia = step.m(i) / (step.delta_t * step.delta_t);  // N/m
    change += move.dot(inertia * (middle - 2 * step.p_curr.row(i) + step.p_prev.row(i)) -
                       step.f_ext.row(i));
  }
  change += held_change(step.pinned, step.targets, step.w, p, q);
  change += held_change(step.pull.vertices, step.pull.targets, step.pull.k, p, q);
  return change + damping_energy_change(step, p, q);
}

}  // namespace mass_spring
