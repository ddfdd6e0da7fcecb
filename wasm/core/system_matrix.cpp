#include "system_matrix.h"

namespace mass_spring {

Triplets system_matrix(const Edges& E, double k, const Vector& m, double delta_t,
                       const Indices& pinned, double w) {
  Triplets Q;
  Q.reserve(4 * E.rows() + m.size() + pinned.size());
  // k AᵀA
  for (int e = 0; e < E.rows(); ++e) {
    const int i = E(e, 0), j = E(e, 1);
    Q.emplace_back(i, i, k);
    Q.emplace_back(j, j, k);
    Q.emplace_back(i, j, -k);
    Q.emplace_back(j, i, -k);
  }
  // M/Δt²
  for (int i = 0; i < m.size(); ++i) Q.emplace_back(i, i, m(i) / (delta_t * delta_t));
  // w CᵀC
  for (const int i : pinned) Q.emplace_back(i, i, w);
  return Q;
}

Triplets system_matrix(const TimeStep& step) {
  Triplets Q = system_matrix(step.E, coupling(step), step.m, step.delta_t, step.pinned, step.w);
  for (const int i : step.pull.vertices) Q.emplace_back(i, i, step.pull.k);
  return Q;
}

}  // namespace mass_spring
