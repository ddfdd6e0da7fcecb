#include "stiffness_numbers.h"

namespace mass_spring {

Vector stiffness_numbers(const Edges& E, double k, const Vector& m, double delta_t) {
  Vector stiffness = Vector::Zero(m.size());  // #V, N/m
  for (int e = 0; e < E.rows(); ++e) {
    stiffness(E(e, 0)) += k;
    stiffness(E(e, 1)) += k;
  }
  return (delta_t * delta_t) * stiffness.cwiseQuotient(m);
}

}  // namespace mass_spring
