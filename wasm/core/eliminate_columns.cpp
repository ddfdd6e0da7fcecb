#include "eliminate_columns.h"

#include <cmath>

namespace mass_spring {
namespace {

class ColumnElimination {
 public:
  ColumnElimination(const FactorPattern& pattern, EliminatedMatrix& matrix)
      : pattern_(pattern), values_(matrix.values), born_(matrix.born) {
    values_.assign(pattern.rows.size(), 0);
    born_.assign(pattern.rows.size(), not_born);
  }

  void enter(const SparseMatrix& Q) {
    for (int column = 0; column < pattern_.size(); ++column) {
      int at = pattern_.start[column];
      for (SparseMatrix::InnerIterator entry(Q, column); entry; ++entry) {
        if (entry.row() < column) continue;
        at = find(static_cast<int>(entry.row()), at);
        values_[at] = entry.value();
        born_[at] = 0;
      }
    }
  }

  bool eliminate(int column) {
    const int begin = pattern_.start[column], end = pattern_.start[column + 1];
    const double pivot = values_[begin];
    // Written so that NaN is refused too.
    if (!(pivot > 0 && std::isfinite(pivot))) return false;
    values_[begin] = std::sqrt(pivot);
    for (int t = begin + 1; t < end; ++t) values_[t] /= values_[begin];
    for (int t = begin + 1; t < end; ++t) {
      int at = pattern_.start[pattern_.rows[t]];
      for (int u = t; u < end; ++u) {
        at = find(pattern_.rows[u], at);
        values_[at] -= values_[u] * values_[t];
        if (born_[at] == not_born) born_[at] = column + 1;
      }
    }
    return true;
  }

 private:
  /// Where a row is, from `at` on in the same column; it is there.
  int find(int row, int at) const {
    while (pattern_.rows[at] < row) ++at;
    return at;
  }

  const FactorPattern& pattern_;
  std::vector<double>& values_;
  std::vector<int>& born_;
};

}  // namespace

bool eliminate_columns(const SparseMatrix& Q, const FactorPattern& pattern, int columns,
                       EliminatedMatrix& matrix) {
  ColumnElimination elimination(pattern, matrix);
  elimination.enter(Q);
  for (int column = 0; column < columns; ++column) {
    if (!elimination.eliminate(column)) return false;
  }
  return true;
}

}  // namespace mass_spring
