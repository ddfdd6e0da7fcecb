#include "column_groups.h"

#include <algorithm>
#include <utility>

namespace mass_spring {
namespace {

/// Time that a group takes in both sweeps of a solve, in units of one stored entry, as measured:
/// entries, indices and the starts of loops.
double cost(std::size_t width, int height) {
  const double w = static_cast<double>(width), h = height;
  return w * (w + 2 * h) + 4 * (w + h) + 20;
}

/// Makes the columns of `child` the first of `parent`: its rows below are among those of the
/// parent.
void absorb(ColumnGroup& parent, ColumnGroup& child) {
  if (parent.columns.size() < child.columns.size()) parent.columns.swap(child.columns);
  parent.columns.insert(parent.columns.end(), child.columns.begin(), child.columns.end());
  parent.children.insert(parent.children.end(), child.children.begin(), child.children.end());
  child = {};
}

/// The groups reachable from the roots, renumbered so that each follows its descendants.
std::vector<ColumnGroup> descendants_first(std::vector<ColumnGroup>& groups,
                                           std::vector<int> roots) {
  std::vector<int> order;  // parents first, in the end
  for (std::vector<int>& pending = roots; !pending.empty();) {
    const int g = pending.back();
    pending.pop_back();
    order.push_back(g);
    pending.insert(pending.end(), groups[g].children.begin(), groups[g].children.end());
  }
  std::reverse(order.begin(), order.end());
  std::vector<int> place(groups.size());
  std::vector<ColumnGroup> ordered;
  for (const int g : order) {
    place[g] = static_cast<int>(ordered.size());
    for (int& child : groups[g].children) child = place[child];
    std::sort(groups[g].columns.begin(), groups[g].columns.end());
    ordered.push_back(std::move(groups[g]));
  }
  return ordered;
}

}  // namespace

std::vector<ColumnGroup> column_groups(const EliminationTree& tree) {
  const int n = static_cast<int>(tree.parent.size());
  std::vector<ColumnGroup> groups(n);  // each named after its last column
  std::vector<int> roots;
  for (int column = 0; column < n; ++column) {
    ColumnGroup& group = groups[column];
    group.columns = {column};
    group.height = tree.height[column];
    std::vector<int> children = std::exchange(group.children, {});
    // Those that differ least from their parent first.
    std::stable_sort(children.begin(), children.end(),
                     [&](int a, int b) { return groups[a].height > groups[b].height; });
    for (const int c : children) {
      ColumnGroup& child = groups[c];
      const double apart =
          cost(group.columns.size(), group.height) + cost(child.columns.size(), child.height);
      if (cost(group.columns.size() + child.columns.size(), group.height) <= apart) {
        absorb(group, child);
      } else {
        group.children.push_back(c);
      }
    }
    (tree.parent[column] < 0 ? roots : groups[tree.parent[column]].children).push_back(column);
  }
  return descendants_first(groups, roots);
}

}  // namespace mass_spring
