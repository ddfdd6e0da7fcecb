#include "fast_mass_springs_precomputation_sparse.h"

#include "edge_lengths.h"
#include "mass_matrix.h"
#include "matrix_from_triplets.h"
#include "selection_matrix.h"
#include "signed_incidence_matrix_sparse.h"
#include "system_matrix.h"

namespace mass_spring {

bool fast_mass_springs_precomputation_sparse(const Points& V, const Edges& E, double k,
                                             const Vector& m, const Indices& pinned, double delta_t,
                                             double w, Vector& r,
                                             SparsePrecomputation& precomputation) {
  const int n = static_cast<int>(V.rows());
  edge_lengths(V, E, r);
  signed_incidence_matrix_sparse(n, E, precomputation.A);
  matrix_from_triplets(n, n, mass_matrix(m), precomputation.M);
  matrix_from_triplets(static_cast<int>(pinned.size()), n, selection_matrix(pinned),
                       precomputation.C);
  return precomputation.Q.factorise(n, system_matrix(E, k, m, delta_t, pinned, w));
}

}  // namespace mass_spring
