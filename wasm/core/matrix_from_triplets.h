#pragma once

#include "types.h"

namespace mass_spring {

/// The `rows` by `columns` matrix of the given entries; repeated ones add up. These two overloads
/// are all in which building a dense and a sparse matrix differ.
void matrix_from_triplets(int rows, int columns, const Triplets& triplets, DenseMatrix& matrix);
void matrix_from_triplets(int rows, int columns, const Triplets& triplets, SparseMatrix& matrix);

}  // namespace mass_spring
