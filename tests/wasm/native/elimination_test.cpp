#include <doctest/doctest.h>

#include <algorithm>

#include "elimination_order.h"
#include "minimum_degree.h"
#include "nested_dissection.h"
#include "random_scene.h"

namespace mass_spring {
namespace {

Graph graph_of(const TestScene& scene) {
  std::vector<std::array<int, 2>> edges;
  for (const auto& edge : scene.step.E.rowwise()) edges.push_back({edge(0), edge(1)});
  return graph_from_edges(static_cast<int>(scene.V.rows()), edges);
}

bool is_permutation(std::vector<int> order, int n) {
  std::sort(order.begin(), order.end());
  for (int i = 0; i < n; ++i) {
    if (order[i] != i) return false;
  }
  return static_cast<int>(order.size()) == n;
}

/// The pattern of L by the definition: eliminating a column joins all of its rows.
Eigen::MatrixXi pattern_of_L(const Graph& graph, const std::vector<int>& order) {
  const int n = graph.size();
  Eigen::MatrixXi L = Eigen::MatrixXi::Identity(n, n);
  for (int row = 0; row < n; ++row) {
    for (int column = 0; column < row; ++column) {
      const auto neighbours = graph.neighbours_of(order[row]);
      L(row, column) = std::count(neighbours.begin(), neighbours.end(), order[column]) > 0;
    }
  }
  for (int column = 0; column < n; ++column) {
    for (int j = column + 1; j < n; ++j) {
      for (int i = j + 1; i < n; ++i) L(i, j) |= L(i, column) & L(j, column);
    }
  }
  return L;
}

}  // namespace

TEST_CASE("a graph lists its edges both ways") {
  const Graph graph = graph_from_edges(4, {{0, 2}, {2, 1}});
  CHECK(graph.size() == 4);
  CHECK(graph.neighbours_of(0) == Indices::Constant(1, 2));
  CHECK(graph.neighbours_of(2) == Eigen::Vector2i(0, 1));
  CHECK(graph.neighbours_of(3).size() == 0);
}

TEST_CASE("both orders eliminate every vertex once, whatever the graph") {
  for (const int vertices : {1, 2, 3, 40}) {
    for (const int springs : {0, vertices / 2, vertices * (vertices - 1) / 2}) {
      const TestScene scene = random_scene(vertices, springs, 0, 3);
      const Graph graph = graph_of(scene);
      const std::vector<int> dissection = nested_dissection(scene.V, graph);
      CHECK(is_permutation(dissection, vertices));
      CHECK(is_permutation(minimum_degree(graph, dissection), vertices));
    }
  }
  CHECK(minimum_degree(Graph(), {}).empty());
  CHECK(nested_dissection(Points(0, 3), Graph()).empty());
}

TEST_CASE("minimum degree takes a star's ends before its centre") {
  const Graph star = graph_from_edges(5, {{2, 0}, {2, 1}, {2, 3}, {2, 4}});
  const std::vector<int> order = minimum_degree(star, {0, 1, 2, 3, 4});
  // With one end left, end and centre are equals.
  CHECK(std::find(order.begin(), order.end(), 2) >= order.end() - 2);
  CHECK(elimination_tree(star, order).nonzeros == 9);
}

TEST_CASE("vertices in one place are dissected too") {
  const Graph graph = graph_of(random_scene(20, 40, 0, 5));
  CHECK(is_permutation(nested_dissection(Points::Zero(20, 3), graph), 20));
}

TEST_CASE("the elimination tree counts the non-zeros of L") {
  for (unsigned seed = 0; seed < 5; ++seed) {
    const TestScene scene = random_scene(30, 45, 0, seed);
    const Graph graph = graph_of(scene);
    const std::vector<int> dissection = nested_dissection(scene.V, graph);
    for (const auto& order : {dissection, minimum_degree(graph, dissection)}) {
      const EliminationTree tree = elimination_tree(graph, order);
      const Eigen::MatrixXi L = pattern_of_L(graph, order);
      CHECK(tree.nonzeros == L.sum());
      for (int column = 0; column < 30; ++column) {
        CHECK(tree.height[column] == L.col(column).sum() - 1);
        int first = column + 1;
        while (first < 30 && !L(first, column)) ++first;
        CHECK(tree.parent[column] == (first < 30 ? first : -1));
      }
    }
  }
}

TEST_CASE("a grid is dissected along straight lines") {
  // 8 by 8, without the flag's diagonals: the fewest vertices that halve it are a line of 8.
  TestScene grid = flag(8, 8, 1);
  std::vector<std::array<int, 2>> edges;
  for (const auto& edge : grid.step.E.rowwise()) {
    if (edge(1) != edge(0) + 9) edges.push_back({edge(0), edge(1)});
  }
  const Graph graph = graph_from_edges(64, edges);
  const std::vector<int> order = nested_dissection(grid.V, graph);
  // Vertex x·8 + y. The halves come first: 24 vertices on one side of the line, 32 on the other.
  const std::vector<int> line(order.end() - 8, order.end());
  const bool upright = line[0] / 8 == line[1] / 8;
  for (const int v : line) CHECK((upright ? v / 8 == line[0] / 8 : v % 8 == line[0] % 8));
  for (int a = 0; a < 24; ++a) {
    const auto neighbours = graph.neighbours_of(order[a]);
    for (int b = 24; b < 56; ++b) {
      CHECK(std::count(neighbours.begin(), neighbours.end(), order[b]) == 0);
    }
  }
}

TEST_CASE("the order with the smaller L is taken") {
  const TestScene scene = flag(12, 9, 1);
  const Graph graph = graph_of(scene);
  const EliminationOrder best = elimination_order(scene.V, graph);
  const std::vector<int> dissection = nested_dissection(scene.V, graph);
  for (const auto& order : {dissection, minimum_degree(graph, dissection)}) {
    CHECK(best.tree.nonzeros <= elimination_tree(graph, order).nonzeros);
  }
  CHECK(best.tree.nonzeros == elimination_tree(graph, best.order).nonzeros);
}

}  // namespace mass_spring
