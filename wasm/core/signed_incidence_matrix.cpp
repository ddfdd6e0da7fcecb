#include "signed_incidence_matrix.h"

namespace mass_spring {

Triplets signed_incidence_matrix(const Edges& E) {
  Triplets A;
  A.reserve(2 * E.rows());
  for (int e = 0; e < E.rows(); ++e) {
    A.emplace_back(e, E(e, 0), 1.0);
    A.emplace_back(e, E(e, 1), -1.0);
  }
  return A;
}

}  // namespace mass_spring
