#include "signed_incidence_matrix_dense.h"

#include "matrix_from_triplets.h"
#include "signed_incidence_matrix.h"

namespace mass_spring {

void signed_incidence_matrix_dense(int n, const Edges& E, DenseMatrix& A) {
  matrix_from_triplets(static_cast<int>(E.rows()), n, signed_incidence_matrix(E), A);
}

}  // namespace mass_spring
