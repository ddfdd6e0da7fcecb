#include "elimination.h"

#include <limits>
#include <numeric>
#include <utility>

#include "eliminate_columns.h"
#include "graph.h"
#include "matrix_in_order.h"

namespace mass_spring {

Elimination::Elimination(const Triplets& Q, std::vector<int> order)
    : order_(std::move(order)), Q_(matrix_in_order(Q, order_)) {
  const Graph graph = graph_from_matrix(Q_);
  std::vector<int> in_order(order_.size());
  std::iota(in_order.begin(), in_order.end(), 0);
  tree_ = elimination_tree(graph, in_order);
  nonzeros_of_Q_ = graph.size() + static_cast<std::int64_t>(graph.neighbours.size()) / 2;
  for (const int height : tree_.height) flops_ += (height + 1.0) * (height + 1.0);
  if (flops_ > most_flops) return;
  pattern_ = factor_pattern(graph, tree_);
  // Of no columns Eigen asserts that there are some.
  if (graph.size() > 0) llt_.analyzePattern(Q_);
}

bool Elimination::factorise() {
  if (flops_ > most_flops) return false;
  if (Q_.rows() == 0) return true;
  llt_.factorize(Q_);
  return llt_.info() == Eigen::Success;
}

Status Elimination::after(int columns, std::vector<EliminatedEntry>& entries) const {
  entries.clear();
  if (columns < 0 || columns > Q_.rows()) {
    return {StatusCode::index_out_of_range, "columns", -1, static_cast<double>(columns)};
  }
  if (flops_ > most_flops) {
    return {StatusCode::too_large, "elimination", -1, flops_, most_flops};
  }
  EliminatedMatrix matrix;
  if (!eliminate_columns(Q_, pattern_, columns, matrix)) {
    return {StatusCode::factorisation_failed, "Q", -1, std::numeric_limits<double>::quiet_NaN()};
  }
  for (int column = 0; column < pattern_.size(); ++column) {
    for (int t = pattern_.start[column]; t < pattern_.start[column + 1]; ++t) {
      if (matrix.born[t] == not_born) continue;
      entries.push_back({pattern_.rows[t], column, matrix.values[t], matrix.born[t]});
    }
  }
  return {};
}

}  // namespace mass_spring
