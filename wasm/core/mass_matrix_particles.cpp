#include "mass_matrix_particles.h"

namespace mass_spring {

Triplets mass_matrix_particles(const Vector& m) {
  Triplets M;
  M.reserve(3 * m.size());
  for (int i = 0; i < m.size(); ++i) {
    for (int c = 0; c < 3; ++c) M.emplace_back(3 * i + c, 3 * i + c, m(i));
  }
  return M;
}

}  // namespace mass_spring
