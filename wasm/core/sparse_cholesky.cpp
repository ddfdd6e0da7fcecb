#include "sparse_cholesky.h"

#include <algorithm>

#include "matrix_from_triplets.h"

namespace mass_spring {
namespace {

bool same_pattern(const SparseMatrix& one, const SparseMatrix& other) {
  return one.rows() == other.rows() && one.nonZeros() == other.nonZeros() &&
         std::equal(one.outerIndexPtr(), one.outerIndexPtr() + one.outerSize(),
                    other.outerIndexPtr()) &&
         std::equal(one.innerIndexPtr(), one.innerIndexPtr() + one.nonZeros(),
                    other.innerIndexPtr());
}

}  // namespace

bool SparseCholesky::factorise(int n, const Triplets& Q) {
  SparseMatrix next;
  matrix_from_triplets(n, n, Q, next);
  const bool analysed = same_pattern(next, Q_);
  Q_.swap(next);
  if (!analysed) llt_.analyzePattern(Q_);
  llt_.factorize(Q_);
  // info() alone says Success for a matrix with infinite entries.
  return llt_.info() == Eigen::Success &&
         Vector(llt_.matrixL().nestedExpression().diagonal()).allFinite();
}

void SparseCholesky::solve(const Points& b, DenseMatrix& x, Points& p) const {
  x.resize(b.rows(), b.cols());
  x.noalias() = llt_.permutationP() * b;
  llt_.matrixL().solveInPlace(x);
  llt_.matrixU().solveInPlace(x);
  p.noalias() = llt_.permutationPinv() * x;
}

std::vector<int> SparseCholesky::order() const {
  const Indices& rows = llt_.permutationPinv().indices();
  return {rows.begin(), rows.end()};
}

}  // namespace mass_spring
