#include "fast_mass_springs_precomputation_sparse.h"

#include "sparse_matrices.h"
#include "system_matrix.h"

namespace mass_spring {

bool fast_mass_springs_precomputation_sparse(const Points& V, const Edges& E, double k,
                                             const Vector& m, const Indices& pinned, double delta_t,
                                             double w, Vector& r,
                                             SparsePrecomputation& precomputation) {
  sparse_matrices(V, E, m, pinned, r, precomputation);
  return precomputation.Q.factorise(static_cast<int>(V.rows()),
                                    system_matrix(E, k, m, delta_t, pinned, w));
}

}  // namespace mass_spring
