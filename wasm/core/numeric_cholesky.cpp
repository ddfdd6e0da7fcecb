#include "numeric_cholesky.h"

#include <algorithm>
#include <cmath>

#include "dot.h"

namespace mass_spring {
namespace {

// Progress is told no oftener than this: multiplications, some milliseconds of them, and shares of
// the whole.
constexpr double progress_interval = 2e7;
constexpr double progress_share = 0.01;

// Rows by columns whose products are summed at once, so that every number loaded serves several.
constexpr int tile_rows = 4;
constexpr int tile_columns = 2;

/// products(i, j) = a_i · b_j, each of n numbers.
void tile_products(const double* const (&a)[tile_rows], const double* const (&b)[tile_columns],
                   int n, double (&products)[tile_rows][tile_columns]) {
  Pair sums[tile_rows][tile_columns] = {};
  int t = 0;
  for (; t + 2 <= n; t += 2) {
    const Pair b0 = load(b[0] + t), b1 = load(b[1] + t);
    for (int i = 0; i < tile_rows; ++i) {
      const Pair ai = load(a[i] + t);
      sums[i][0] += ai * b0;
      sums[i][1] += ai * b1;
    }
  }
  for (int i = 0; i < tile_rows; ++i) {
    for (int j = 0; j < tile_columns; ++j) {
      products[i][j] = sum(sums[i][j]);
      if (t < n) products[i][j] += a[i][t] * b[j][t];
    }
  }
}

class NumericCholesky {
 public:
  NumericCholesky(const SymbolicCholesky& symbolic, std::vector<double>& values)
      : symbolic_(symbolic),
        values_(values),
        owner_(symbolic.order.size()),
        row_in_panel_(symbolic.order.size()),
        first_due_(symbolic.supernodes.size(), none),
        next_due_(symbolic.supernodes.size(), none),
        used_rows_(symbolic.supernodes.size(), 0) {
    for (int s = 0; s < size(); ++s) {
      for (int c = 0; c < node(s).width; ++c) owner_[node(s).first_column + c] = s;
      total_work_ += work(s);
    }
  }

  /// Left-looking: a panel takes what all panels left of it subtract from it, then is factorised.
  bool run(double coupling, const Vector& diagonal, const Progress& progress) {
    values_.assign(symbolic_.values, 0);
    for (const std::int64_t entry : symbolic_.edge_values) values_[entry] = -coupling;
    const double interval = std::max(progress_interval, progress_share * total_work_);
    double done = 0, reported = 0;
    for (int t = 0; t < size(); ++t) {
      for (int c = 0; c < node(t).width; ++c) {
        row(t, c)[c] = diagonal(node(t).first_column + c);
      }
      number_rows(t);
      for (int s = first_due_[t]; s != none;) {
        const int next = next_due_[s];
        subtract_products(s, t);
        s = next;
      }
      if (!factorise_panel(t)) return false;
      make_due(t);
      done += work(t);
      if (done - reported >= interval) {
        progress(done / total_work_);
        reported = done;
      }
    }
    return true;
  }

 private:
  static constexpr int none = -1;

  int size() const { return static_cast<int>(symbolic_.supernodes.size()); }
  const Supernode& node(int s) const { return symbolic_.supernodes[s]; }
  const int* rows_below(int s) const { return symbolic_.rows.data() + node(s).rows; }

  /// Row i of a panel, those of the triangle first.
  double* row(int s, int i) const {
    return values_.data() + node(s).panel + static_cast<std::int64_t>(i) * node(s).width;
  }
  double* row_below(int s, int i) const { return row(s, node(s).width + i); }

  double work(int s) const {
    const double length = node(s).width + node(s).height;
    return node(s).width * length * length;
  }

  void number_rows(int t) {
    for (int c = 0; c < node(t).width; ++c) row_in_panel_[node(t).first_column + c] = c;
    for (int i = 0; i < node(t).height; ++i) row_in_panel_[rows_below(t)[i]] = node(t).width + i;
  }

  /// Queues a panel for the one whose columns are its next unused rows.
  void make_due(int s) {
    if (used_rows_[s] == node(s).height) return;
    const int target = owner_[rows_below(s)[used_rows_[s]]];
    next_due_[s] = first_due_[target];
    first_due_[target] = s;
  }

  /// From the panel t, L_R L_Cᵀ of the panel s: C those of its rows that are columns of t, R these
  /// and all below.
  void subtract_products(int s, int t) {
    const int* rows = rows_below(s);
    const int begin = used_rows_[s], last = node(s).height - 1;
    const int end_of_columns = node(t).first_column + node(t).width;
    const int end = static_cast<int>(
        std::lower_bound(rows + begin, rows + node(s).height, end_of_columns) - rows);
    for (int i = begin; i <= last; i += tile_rows) {
      const double* a[tile_rows];
      for (int k = 0; k < tile_rows; ++k) a[k] = row_below(s, std::min(i + k, last));
      // Above the diagonal nothing is needed.
      const int end_of_tiles = std::min(end, i + tile_rows);
      for (int j = begin; j < end_of_tiles; j += tile_columns) {
        const double* b[tile_columns];
        for (int k = 0; k < tile_columns; ++k) b[k] = row_below(s, std::min(j + k, last));
        double products[tile_rows][tile_columns];
        tile_products(a, b, node(s).width, products);
        for (int ki = 0; ki < std::min(tile_rows, node(s).height - i); ++ki) {
          double* target = row(t, row_in_panel_[rows[i + ki]]);
          for (int kj = 0; kj < std::min(tile_columns, end_of_tiles - j); ++kj) {
            target[rows[j + kj] - node(t).first_column] -= products[ki][kj];
          }
        }
      }
    }
    used_rows_[s] = end;
    make_due(s);
  }

  /// Row by row, L(i, c) = (a(i, c) - Σ_{q<c} L(i, q) L(c, q)) / L(c, c).
  bool factorise_panel(int t) {
    for (int i = 0; i < node(t).width + node(t).height; ++i) {
      double* L_i = row(t, i);
      for (int c = 0; c < std::min(i, node(t).width); ++c) {
        L_i[c] = (L_i[c] - dot(L_i, row(t, c), c)) / row(t, c)[c];
      }
      if (i < node(t).width) {
        const double pivot = L_i[i] - dot(L_i, L_i, i);
        // Written so that NaN is refused too.
        if (!(pivot > 0 && std::isfinite(pivot))) return false;
        L_i[i] = std::sqrt(pivot);
      }
    }
    return true;
  }

  const SymbolicCholesky& symbolic_;
  std::vector<double>& values_;
  std::vector<int> owner_;         // #columns: the supernode of each
  std::vector<int> row_in_panel_;  // #columns: of the panel being made
  // Lists of the panels that have something to subtract next from each panel.
  std::vector<int> first_due_, next_due_;  // #supernodes
  std::vector<int> used_rows_;             // #supernodes: how many rows below are dealt with
  double total_work_ = 0;                  // multiplications, about
};

}  // namespace

bool numeric_cholesky(const SymbolicCholesky& symbolic, double coupling, const Vector& diagonal,
                      const Progress& progress, std::vector<double>& values) {
  return NumericCholesky(symbolic, values).run(coupling, diagonal, progress);
}

}  // namespace mass_spring
