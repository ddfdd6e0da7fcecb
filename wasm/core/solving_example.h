#pragma once

#include "dense_cholesky.h"
#include "sparse_cholesky.h"
#include "types.h"

namespace mass_spring {

/// Q p = b and the ways to solve it, each a call of its own: to be timed. A solve comes after its
/// factorisation.
class SolvingExample {
 public:
  /// Beyond so many unknowns dense calls do nothing and return false: Q and its inverse
  /// would take more than 33 MB each.
  static constexpr int largest_dense = 2025;

  /// Of a square net of `side` by `side` vertices.
  /// @param side  at least 2
  explicit SolvingExample(int side);
  /// Of any system, loaded by gravity.
  /// @param Q  N/m
  explicit SolvingExample(const SparseMatrix& Q);

  int vertex_count() const { return static_cast<int>(b_.rows()); }

  /// About 2n³ operations.
  bool dense_inverse();
  /// About n³/3 operations.
  bool dense_factorise();
  /// 2n² operations for each of the three columns of b.
  bool dense_substitute();
  /// About n^1.5 operations, with a good ordering.
  void sparse_factorise();
  /// About n log n operations.
  void sparse_substitute();
  /// Of Q and, once it is factorised, of L, by either storage.
  double dense_bytes() const;
  double sparse_matrix_bytes() const;
  double sparse_factor_bytes() const;
  /// max |Q p - b| of the last substitution, N.
  double residual() const;

 private:
  bool fits_dense() const { return vertex_count() <= largest_dense; }

  Triplets Q_;           // #V by #V, N/m
  Points b_;             // #V by 3, N
  Points p_;             // #V by 3, m
  DenseMatrix scratch_;  // #V by 3
  DenseMatrix inverse_;  // #V by #V
  DenseCholesky dense_;
  SparseCholesky sparse_;
};

}  // namespace mass_spring
