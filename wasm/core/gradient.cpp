#include "gradient.h"

#include "damping_energy.h"
#include "edge_vectors.h"
#include "local_step.h"

namespace mass_spring {

void gradient(const TimeStep& step, const Points& p, Points& g) {
  // M (p - 2p^t + p^{t-Δt})/Δt² - f^ext
  const Vector inertia = step.m / (step.delta_t * step.delta_t);  // #V, N/m
  g = inertia.asDiagonal() * (p - 2 * step.p_curr + step.p_prev) - step.f_ext;
  // k Aᵀ(A p - d(p))
  Points x, d;  // #E by 3, m
  edge_vectors(step.E, p, x);
  local_step(step.E, step.r, p, d);
  for (int e = 0; e < step.E.rows(); ++e) {
    g.row(step.E(e, 0)) += step.k * (x.row(e) - d.row(e));
    g.row(step.E(e, 1)) -= step.k * (x.row(e) - d.row(e));
  }
  // w Cᵀ(C p - p^target)
  for (int c = 0; c < step.pinned.size(); ++c) {
    g.row(step.pinned(c)) += step.w * (p.row(step.pinned(c)) - step.targets.row(c));
  }
  add_damping_gradient(step, p, g);
  const Pull& pull = step.pull;
  for (int c = 0; c < pull.vertices.size(); ++c) {
    g.row(pull.vertices(c)) += pull.k * (p.row(pull.vertices(c)) - pull.targets.row(c));
  }
}

}  // namespace mass_spring
