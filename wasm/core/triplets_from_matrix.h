#pragma once

#include "types.h"

namespace mass_spring {

/// The entries of a matrix, each (row, column) once, column by column; of a dense matrix those that
/// are not zero.
Triplets triplets_from_matrix(const DenseMatrix& matrix);
Triplets triplets_from_matrix(const SparseMatrix& matrix);

}  // namespace mass_spring
