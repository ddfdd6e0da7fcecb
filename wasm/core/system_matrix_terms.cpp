#include "system_matrix_terms.h"

#include "mass_matrix.h"
#include "matrix_from_triplets.h"
#include "selection_matrix.h"
#include "signed_incidence_matrix.h"

namespace mass_spring {

SystemMatrixTerms system_matrix_terms(const TimeStep& step) {
  const int n = static_cast<int>(step.m.size());
  SparseMatrix A, M, C;
  matrix_from_triplets(static_cast<int>(step.E.rows()), n, signed_incidence_matrix(step.E), A);
  matrix_from_triplets(n, n, mass_matrix(step.m), M);
  matrix_from_triplets(static_cast<int>(step.pinned.size()), n, selection_matrix(step.pinned), C);
  SystemMatrixTerms terms;
  terms.AtA = SparseMatrix(A.transpose()) * A;
  terms.springs = step.k * terms.AtA;
  terms.masses = M / (step.delta_t * step.delta_t);
  terms.pins = step.w * (SparseMatrix(C.transpose()) * C);
  return terms;
}

}  // namespace mass_spring
