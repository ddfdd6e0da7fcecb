#pragma once

#include <Eigen/SparseCholesky>
#include <vector>

#include "types.h"

namespace mass_spring {

/// P Q Pᵀ = L Lᵀ with only the non-zeros stored; P is the fill-reducing ordering (approximate
/// minimum degree).
class SparseCholesky {
 public:
  /// The ordering and the pattern of L are found once for a pattern of Q; other values only refill
  /// it.
  /// @param n  #V
  /// @param Q  entries of the #V by #V matrix
  /// @return whether Q is positive definite as far as the arithmetic can tell
  bool factorise(int n, const Triplets& Q);

  /// Solves Q p = b.
  /// @param b  #V by 3
  /// @param x  scratch, kept by the caller between calls
  /// @param p  #V by 3 (result)
  void solve(const Points& b, DenseMatrix& x, Points& p) const;

  /// Which row of Q is eliminated first, second, …: P.
  std::vector<int> order() const;

  /// That L takes.
  double bytes() const {
    return static_cast<double>(llt_.matrixL().nestedExpression().nonZeros()) *
           (sizeof(double) + sizeof(int));
  }

 private:
  SparseMatrix Q_;  // #V by #V
  Eigen::SimplicialLLT<SparseMatrix> llt_;
};

}  // namespace mass_spring
