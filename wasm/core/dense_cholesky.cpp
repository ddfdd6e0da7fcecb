#include "dense_cholesky.h"

#include <Eigen/Cholesky>
#include <numeric>

#include "matrix_from_triplets.h"

namespace mass_spring {

bool DenseCholesky::factorise(int n, const Triplets& Q) {
  matrix_from_triplets(n, n, Q, L_);
  const Eigen::LLT<Eigen::Ref<DenseMatrix>> in_place(L_);
  // info() alone says Success for a matrix with infinite entries.
  return in_place.info() == Eigen::Success && L_.diagonal().allFinite();
}

void DenseCholesky::solve(const Points& b, DenseMatrix& x, Points& p) const {
  x = b;
  L_.triangularView<Eigen::Lower>().solveInPlace(x);
  L_.transpose().triangularView<Eigen::Upper>().solveInPlace(x);
  p = x;
}

std::vector<int> DenseCholesky::order() const {
  std::vector<int> rows(L_.rows());
  std::iota(rows.begin(), rows.end(), 0);
  return rows;
}

}  // namespace mass_spring
