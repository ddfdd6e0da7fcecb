#pragma once

#include <vector>

#include "factor_pattern.h"
#include "types.h"

namespace mass_spring {

/// What the lower triangle of a matrix has become after some of its columns were eliminated: these
/// hold L, the block that remains what is yet to be eliminated, its Schur complement Q_22 - L_21
/// L_21ᵀ.
struct EliminatedMatrix {
  std::vector<double> values;  // of every entry of the pattern of L
  // After how many columns each entry came into being: 0 for those of Q, more for fill-in, and
  // not_born for fill-in that is yet to come.
  std::vector<int> born;
};

constexpr int not_born = -1;

/// Column by column, dividing by the root of its pivot and subtracting from what is right of it the
/// products of its entries. [George and Liu 1981, "Computer Solution of Large Sparse Positive
/// Definite Systems", section 2.1: the outer product form]
/// @param Q        #columns by #columns, symmetric
/// @param pattern  of its L
/// @param columns  how many of them to eliminate, from the left
/// @param matrix   (result)
/// @return whether the pivots were positive; if not, the result means nothing
bool eliminate_columns(const SparseMatrix& Q, const FactorPattern& pattern, int columns,
                       EliminatedMatrix& matrix);

}  // namespace mass_spring
