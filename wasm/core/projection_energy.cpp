#include "projection_energy.h"

#include "edge_vectors.h"

namespace mass_spring {

double projection_energy(const Edges& E, double k, const Points& d, const Points& p) {
  Points x;  // #E by 3, m
  edge_vectors(E, p, x);
  return 0.5 * k * (x - d).squaredNorm();
}

}  // namespace mass_spring
