#include "inertia.h"

namespace mass_spring {

double inertia(const Vector& m, double delta_t, const Points& p_prev, const Points& p_curr,
               const Points& p) {
  return 0.5 / (delta_t * delta_t) * m.dot((p - 2 * p_curr + p_prev).rowwise().squaredNorm());
}

}  // namespace mass_spring
