#pragma once

#include <Eigen/SparseCholesky>
#include <cstdint>
#include <vector>

#include "elimination_tree.h"
#include "factor_pattern.h"
#include "status.h"
#include "types.h"

namespace mass_spring {

/// An entry of a matrix that is being eliminated.
struct EliminatedEntry {
  int row, column;
  double value;
  int born;  // after how many columns it came into being: 0 if it is one of Q, else it is fill-in
};

/// The factorisation P Q Pᵀ = L Lᵀ in a given order, to be looked at: what it costs without making
/// it, and how it goes column by column.
class Elimination {
 public:
  /// Of what takes more flops, L is only counted: it would take seconds and some 100 MB.
  static constexpr double most_flops = 5e8;

  /// @param Q      entries of the matrix: symmetric, with a positive diagonal
  /// @param order  which row is eliminated first, second, …; what is not in it is left out of Q
  Elimination(const Triplets& Q, std::vector<int> order);

  const std::vector<int>& order() const { return order_; }
  const EliminationTree& tree() const { return tree_; }
  /// Of the lower triangle of Q, the diagonal included.
  std::int64_t nonzeros_of_Q() const { return nonzeros_of_Q_; }
  /// Entries of L that are none of Q.
  std::int64_t fill() const { return tree_.nonzeros - nonzeros_of_Q_; }
  /// Σ c², c the non-zeros of a column of L: a root, c - 1 divisions, c (c - 1)/2 multiplications
  /// and as many subtractions. [Davis 2006, "Direct Methods for Sparse Linear Systems", section 4]
  double flops() const { return flops_; }

  /// Computes all of L by Eigen's algorithm, to be timed.
  /// @return false where that takes too many flops or Q is not positive definite
  bool factorise();

  /// The lower triangle after that many columns, of which then hold L: entry for entry what it is
  /// on the way to any later column, whichever was asked for before.
  /// @param columns  0 … #order
  /// @param entries  column by column, rows ascending; only those that have come into being
  /// (result)
  /// @return index_out_of_range, too_large, or factorisation_failed where Q is not positive
  /// definite
  Status after(int columns, std::vector<EliminatedEntry>& entries) const;

 private:
  std::vector<int> order_;
  SparseMatrix Q_;  // P Q Pᵀ
  EliminationTree tree_;
  FactorPattern pattern_;  // empty where L is only counted
  std::int64_t nonzeros_of_Q_ = 0;
  double flops_ = 0;
  Eigen::SimplicialLLT<SparseMatrix, Eigen::Lower, Eigen::NaturalOrdering<int>> llt_;
};

}  // namespace mass_spring
