#include "potential_energy.h"

#include "edge_lengths.h"

namespace mass_spring {

double potential_energy(const Edges& E, double k, const Vector& r, const Points& p) {
  Vector lengths;  // #E, m
  edge_lengths(p, E, lengths);
  return 0.5 * k * (lengths - r).squaredNorm();
}

}  // namespace mass_spring
