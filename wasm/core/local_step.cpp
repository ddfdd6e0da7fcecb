#include "local_step.h"

#include "edge_vectors.h"

namespace mass_spring {

// m: squares of shorter lengths underflow, so that their direction is lost.
constexpr double collapsed_length = 1e-150;

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
