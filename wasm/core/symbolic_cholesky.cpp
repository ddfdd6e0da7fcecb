#include "symbolic_cholesky.h"

#include <algorithm>

#include "column_groups.h"
#include "inverse_permutation.h"

namespace mass_spring {
namespace {

// Columns. The diagonal block of a panel is stored as a full square, so wide ones waste time;
// narrow ones repeat indices.
constexpr int widest_panel = 64;

/// Rows below the groups' own columns in which each has non-zeros, ascending.
std::vector<std::vector<int>> rows_of_groups(const Graph& graph, const std::vector<int>& order,
                                             const std::vector<ColumnGroup>& groups) {
  const std::vector<int> place = inverse_permutation(order);
  std::vector<std::vector<int>> rows(groups.size());
  std::vector<int> listed(order.size(), -1);  // the last group in which a row was
  int end = 0;                                // of the columns of groups up to g
  for (int g = 0; g < static_cast<int>(groups.size()); ++g) {
    const int begin = end;
    end += static_cast<int>(groups[g].columns.size());
    const auto list = [&](int row) {
      if (row < end || listed[row] == g) return;
      listed[row] = g;
      rows[g].push_back(row);
    };
    // What eliminating these columns joins: their neighbours in the graph and in L so far.
    for (int column = begin; column < end; ++column) {
      for (const int neighbour : graph.neighbours_of(order[column])) list(place[neighbour]);
    }
    for (const int child : groups[g].children) {
      for (const int row : rows[child]) list(row);
    }
    std::sort(rows[g].begin(), rows[g].end());
  }
  return rows;
}

/// Adds the columns [begin, end) with rows below, in panels of equal width.
void add_supernodes(int begin, int end, const std::vector<int>& rows, SymbolicCholesky& symbolic) {
  const int panels = (end - begin + widest_panel - 1) / widest_panel;
  for (int i = 0; i < panels; ++i) {
    const int width = (end - begin) / (panels - i);
    const int height = end - begin - width + static_cast<int>(rows.size());
    symbolic.supernodes.push_back(
        {begin, width, height, static_cast<int>(symbolic.rows.size()), symbolic.values});
    begin += width;
    for (int row = begin; row < end; ++row) symbolic.rows.push_back(row);
    symbolic.rows.insert(symbolic.rows.end(), rows.begin(), rows.end());
    symbolic.values += static_cast<std::int64_t>(width + height) * width;
    symbolic.largest_panel = std::max(symbolic.largest_panel, width + height);
  }
}

/// Where the panels hold the entries of Q below its diagonal.
std::vector<std::int64_t> edge_values(const Graph& graph, const SymbolicCholesky& symbolic) {
  const std::vector<int> place = inverse_permutation(symbolic.order);
  std::vector<int> row_in_panel(graph.size());
  std::vector<std::int64_t> values;
  for (const Supernode& node : symbolic.supernodes) {
    const int end = node.first_column + node.width;
    for (int c = 0; c < node.width; ++c) row_in_panel[node.first_column + c] = c;
    for (int i = 0; i < node.height; ++i) {
      row_in_panel[symbolic.rows[node.rows + i]] = node.width + i;
    }
    for (int column = node.first_column; column < end; ++column) {
      for (const int neighbour : graph.neighbours_of(symbolic.order[column])) {
        if (place[neighbour] < column) continue;
        const std::int64_t row = row_in_panel[place[neighbour]];
        values.push_back(node.panel + row * node.width + column - node.first_column);
      }
    }
  }
  return values;
}

}  // namespace

SymbolicCholesky symbolic_cholesky(const Graph& graph, const EliminationOrder& elimination) {
  const std::vector<ColumnGroup> groups = column_groups(elimination.tree);
  SymbolicCholesky symbolic;
  for (const ColumnGroup& group : groups) {
    for (const int column : group.columns) symbolic.order.push_back(elimination.order[column]);
  }
  const std::vector<std::vector<int>> rows = rows_of_groups(graph, symbolic.order, groups);
  int begin = 0;
  for (std::size_t g = 0; g < groups.size(); ++g) {
    const int end = begin + static_cast<int>(groups[g].columns.size());
    add_supernodes(begin, end, rows[g], symbolic);
    begin = end;
  }
  symbolic.edge_values = edge_values(graph, symbolic);
  return symbolic;
}

}  // namespace mass_spring
