#include "local_step.h"

#include "edge_vectors.h"
#include "spring_direction.h"

namespace mass_spring {

void local_step(const Edges& E, const Vector& r, const Points& p, Points& d) {
  edge_vectors(E, p, d);
  for (int e = 0; e < E.rows(); ++e) {
    const double length = d.row(e).norm();
    if (length < collapsed_length) {
      d.row(e) << r(e), 0, 0;
    } else {
      d.row(e) *= r(e) / length;
    }
  }
}

}  // namespace mass_spring
