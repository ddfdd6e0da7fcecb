#include "triplets_from_matrix.h"

namespace mass_spring {

Triplets triplets_from_matrix(const DenseMatrix& matrix) {
  Triplets triplets;
  for (int j = 0; j < matrix.cols(); ++j) {
    for (int i = 0; i < matrix.rows(); ++i) {
      if (matrix(i, j) != 0) triplets.emplace_back(i, j, matrix(i, j));
    }
  }
  return triplets;
}

Triplets triplets_from_matrix(const SparseMatrix& matrix) {
  Triplets triplets;
  for (int j = 0; j < matrix.cols(); ++j) {
    for (SparseMatrix::InnerIterator entry(matrix, j); entry; ++entry) {
      triplets.emplace_back(static_cast<int>(entry.row()), j, entry.value());
    }
  }
  return triplets;
}

}  // namespace mass_spring
