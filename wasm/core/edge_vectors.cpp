#include "edge_vectors.h"

namespace mass_spring {

void edge_vectors(const Edges& E, const Points& p, Points& x) {
  x.resize(E.rows(), 3);
  for (int e = 0; e < E.rows(); ++e) x.row(e) = p.row(E(e, 0)) - p.row(E(e, 1));
}

}  // namespace mass_spring
