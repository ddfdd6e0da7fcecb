#include "sparse_matrices.h"

#include "edge_lengths.h"
#include "mass_matrix.h"
#include "matrix_from_triplets.h"
#include "selection_matrix.h"
#include "signed_incidence_matrix_sparse.h"

namespace mass_spring {

void sparse_matrices(const Points& V, const Edges& E, const Vector& m, const Indices& pinned,
                     Vector& r, SparsePrecomputation& precomputation) {
  const int n = static_cast<int>(V.rows());
  edge_lengths(V, E, r);
  signed_incidence_matrix_sparse(n, E, precomputation.A);
  matrix_from_triplets(n, n, mass_matrix(m), precomputation.M);
  matrix_from_triplets(static_cast<int>(pinned.size()), n, selection_matrix(pinned),
                       precomputation.C);
}

}  // namespace mass_spring
