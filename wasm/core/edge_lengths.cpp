#include "edge_lengths.h"

#include "edge_vectors.h"

namespace mass_spring {

void edge_lengths(const Points& p, const Edges& E, Vector& lengths) {
  Points x;  // #E by 3, m
  edge_vectors(E, p, x);
  lengths = x.rowwise().norm();
}

}  // namespace mass_spring
