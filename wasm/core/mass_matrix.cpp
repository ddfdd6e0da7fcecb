#include "mass_matrix.h"

namespace mass_spring {

Triplets mass_matrix(const Vector& m) {
  Triplets M;
  M.reserve(m.size());
  for (int i = 0; i < m.size(); ++i) M.emplace_back(i, i, m(i));
  return M;
}

}  // namespace mass_spring
