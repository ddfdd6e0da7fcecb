#pragma once

#include "types.h"

namespace mass_spring {

/// The signed incidence matrix of the springs, built from its triplets. [J] "Matrix form"
/// @param n  #V
/// @param E  #E by 2
/// @param A  #E by #V (result): row e of A p is p_i - p_j
void signed_incidence_matrix_sparse(int n, const Edges& E, SparseMatrix& A);

}  // namespace mass_spring
