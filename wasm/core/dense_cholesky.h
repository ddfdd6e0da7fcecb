#pragma once

#include <vector>

#include "types.h"

namespace mass_spring {

/// Q = L Lᵀ with every entry stored. The factor takes the place of the matrix: for 3,240 vertices
/// each is 84 MB.
class DenseCholesky {
 public:
  /// @param n  #V
  /// @param Q  entries of the #V by #V matrix
  /// @return whether Q is positive definite as far as the arithmetic can tell
  bool factorise(int n, const Triplets& Q);

  /// Solves Q p = b.
  /// @param b  #V by 3
  /// @param x  scratch, kept by the caller between calls
  /// @param p  #V by 3 (result)
  void solve(const Points& b, DenseMatrix& x, Points& p) const;

  /// Which row of Q is eliminated first, second, …: as they are numbered.
  std::vector<int> order() const;

  /// That L takes.
  double bytes() const { return static_cast<double>(L_.size()) * sizeof(double); }

 private:
  DenseMatrix L_;  // #V by #V, the lower triangle; above it, the unused half of Q
};

}  // namespace mass_spring
