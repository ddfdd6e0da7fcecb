#include "matrix_from_triplets.h"

namespace mass_spring {

void matrix_from_triplets(int rows, int columns, const Triplets& triplets, DenseMatrix& matrix) {
  matrix.setZero(rows, columns);
  for (const auto& entry : triplets) matrix(entry.row(), entry.col()) += entry.value();
}

void matrix_from_triplets(int rows, int columns, const Triplets& triplets, SparseMatrix& matrix) {
  matrix.resize(rows, columns);
  matrix.setFromTriplets(triplets.begin(), triplets.end());
}

}  // namespace mass_spring
