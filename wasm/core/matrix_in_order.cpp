#include "matrix_in_order.h"

#include <algorithm>

#include "matrix_from_triplets.h"

namespace mass_spring {

SparseMatrix matrix_in_order(const Triplets& Q, const std::vector<int>& order) {
  const int n = static_cast<int>(order.size());
  int size = 0;  // of Q, as far as it has entries
  for (const auto& entry : Q) size = std::max({size, entry.row() + 1, entry.col() + 1});
  for (const int row : order) size = std::max(size, row + 1);
  std::vector<int> place(size, -1);
  for (int c = 0; c < n; ++c) place[order[c]] = c;
  Triplets kept;
  for (const auto& entry : Q) {
    const int row = place[entry.row()], column = place[entry.col()];
    if (row >= 0 && column >= 0) kept.emplace_back(row, column, entry.value());
  }
  SparseMatrix ordered;
  matrix_from_triplets(n, n, kept, ordered);
  return ordered;
}

}  // namespace mass_spring
