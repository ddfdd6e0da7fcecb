#include "linearly_implicit_terms.h"

#include "assemble_damping.h"
#include "assemble_stiffness.h"
#include "fixed_point_constraints.h"
#include "mass_matrix_particles.h"
#include "matrix_from_triplets.h"

namespace mass_spring {

LinearlyImplicitTerms linearly_implicit_terms(const TimeStep& step, const Points& q) {
  const int n = static_cast<int>(step.m.size());
  const double delta_t = step.delta_t;
  LinearlyImplicitTerms terms;
  SparseMatrix M;
  matrix_from_triplets(3 * n, 3 * n, mass_matrix_particles(step.m), M);
  matrix_from_triplets(3 * n, 3 * n, assemble_stiffness(step, q), terms.K);
  matrix_from_triplets(3 * n, 3 * n, assemble_damping(step, q), terms.D);
  const Triplets selected = fixed_point_constraints(n, step.pinned);
  matrix_from_triplets(static_cast<int>(selected.size()), 3 * n, selected, terms.P);
  terms.system = M - delta_t * terms.D - delta_t * delta_t * terms.K;
  terms.constrained = terms.P * terms.system * terms.P.transpose();
  return terms;
}

}  // namespace mass_spring
