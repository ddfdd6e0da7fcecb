#include "nested_dissection.h"

#include <algorithm>
#include <numeric>
#include <tuple>
#include <utility>

namespace mass_spring {
namespace {

/// No vertex of one half is joined to one of the other.
struct Cut {
  std::vector<int> halves[2];
  std::vector<int> separator;
};

class Dissection {
 public:
  Dissection(const Points& V, const Graph& graph) : V_(V), graph_(graph), half_(graph.size(), 0) {
    std::vector<int> all(graph.size());
    std::iota(all.begin(), all.end(), 0);
    dissect(std::move(all));
  }

  std::vector<int> order() && { return std::move(order_); }

 private:
  void dissect(std::vector<int> vertices) {
    if (vertices.size() > 2) {
      Cut cut = cut_across(0, vertices);
      for (const int axis : {1, 2}) {
        Cut other = cut_across(axis, vertices);
        if (other.separator.size() < cut.separator.size()) cut = std::move(other);
      }
      for (std::vector<int>& half : cut.halves) dissect(std::move(half));
      vertices = std::move(cut.separator);
    }
    order_.insert(order_.end(), vertices.begin(), vertices.end());
  }

  /// Halves of equal size along the axis; those of one half that are joined to the other, of the
  /// half where they are fewer, become the separator.
  Cut cut_across(int axis, std::vector<int> vertices) {
    sort_along(axis, vertices);
    const auto middle = vertices.begin() + vertices.size() / 2;
    Cut cut{{{vertices.begin(), middle}, {middle, vertices.end()}}, {}};
    const int names[2] = {++last_half_, ++last_half_};
    for (const int h : {0, 1}) {
      for (const int v : cut.halves[h]) half_[v] = names[h];
    }
    std::vector<int> border[2];
    for (const int h : {0, 1}) {
      for (const int v : cut.halves[h]) {
        if (touches(v, names[1 - h])) border[h].push_back(v);
      }
    }
    const int h = border[0].size() <= border[1].size() ? 0 : 1;
    std::vector<int>& half = cut.halves[h];
    half.erase(
        std::remove_if(half.begin(), half.end(), [&](int v) { return touches(v, names[1 - h]); }),
        half.end());
    cut.separator = std::move(border[h]);
    return cut;
  }

  /// Vertices level along the axis go by the other axes, so that a cut through a grid is straight.
  void sort_along(int axis, std::vector<int>& vertices) const {
    const auto key = [&](int v) {
      return std::make_tuple(V_(v, axis), V_(v, (axis + 1) % 3), V_(v, (axis + 2) % 3), v);
    };
    std::sort(vertices.begin(), vertices.end(), [&](int a, int b) { return key(a) < key(b); });
  }

  bool touches(int v, int half) const {
    const auto neighbours = graph_.neighbours_of(v);
    return std::any_of(neighbours.begin(), neighbours.end(),
                       [&](int u) { return half_[u] == half; });
  }

  const Points& V_;
  const Graph& graph_;
  std::vector<int> order_;
  std::vector<int> half_;  // #vertices: name of the half that each was in last
  int last_half_ = 0;
};

}  // namespace

std::vector<int> nested_dissection(const Points& V, const Graph& graph) {
  return Dissection(V, graph).order();
}

}  // namespace mass_spring
