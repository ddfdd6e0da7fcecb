#include "block_solver.h"

#include <doctest/doctest.h>

#include "elimination_order.h"
#include "numeric_cholesky.h"
#include "random_scene.h"

namespace mass_spring {
namespace {

/// Q of a graph with unit couplings, in the order of elimination.
struct TestSystem {
  SymbolicCholesky symbolic;
  std::int64_t nonzeros;  // that L can have
  Vector diagonal;        // #columns
  DenseMatrix Q;          // #columns by #columns

  explicit TestSystem(const TestScene& scene) {
    const int n = static_cast<int>(scene.V.rows());
    std::vector<std::array<int, 2>> edges;
    for (const auto& edge : scene.step.E.rowwise()) edges.push_back({edge(0), edge(1)});
    const Graph graph = graph_from_edges(n, edges);
    const EliminationOrder elimination = elimination_order(scene.V, graph);
    symbolic = symbolic_cholesky(graph, elimination);
    nonzeros = elimination.tree.nonzeros;
    Eigen::MatrixXd adjacency = Eigen::MatrixXd::Zero(n, n);
    for (const auto& [i, j] : edges) adjacency(i, j) = adjacency(j, i) = 1;
    Q = -adjacency(symbolic.order, symbolic.order);
    diagonal = 0.1 - Q.rowwise().sum().array();
    Q.diagonal() = diagonal;
  }
};

/// Sparse, dense, in pieces, without any spring; larger than a panel is wide; of one vertex.
std::vector<TestSystem> systems() {
  std::vector<TestSystem> systems;
  for (const auto& [vertices, springs] :
       {std::pair{1, 0}, {7, 0}, {40, 30}, {60, 110}, {50, 600}, {150, 11175}}) {
    systems.emplace_back(random_scene(vertices, springs, 0, 11));
  }
  systems.emplace_back(flag(20, 9, 1));
  return systems;
}

void ignore(double) {}

}  // namespace

TEST_CASE("the panels hold L with P Q P' = L L'") {
  for (const TestSystem& system : systems()) {
    std::vector<double> values;
    REQUIRE(numeric_cholesky(system.symbolic, 1, system.diagonal, ignore, values));
    DenseMatrix L = DenseMatrix::Zero(system.Q.rows(), system.Q.cols());
    for (const Supernode& node : system.symbolic.supernodes) {
      const double* value = values.data() + node.panel;
      for (int i = 0; i < node.width + node.height; ++i) {
        const int row = i < node.width ? node.first_column + i
                                       : system.symbolic.rows[node.rows + i - node.width];
        for (int c = 0; c < node.width; ++c, ++value) {
          if (c <= i) L(row, node.first_column + c) = *value;
        }
      }
    }
    // Entries of at most 150, each with a few roundings.
    CHECK((L * L.transpose() - system.Q).cwiseAbs().maxCoeff() < 1e-12);
    CHECK((L.array() != 0).count() <= system.nonzeros);
  }
}

TEST_CASE("(P Q P') x = b is solved") {
  for (const TestSystem& system : systems()) {
    const int n = static_cast<int>(system.Q.rows());
    BlockSolver solver;
    REQUIRE(solver.factorise(system.symbolic, 1, system.diagonal, ignore));
    const Points b = random_points(n, 13);
    const Eigen::RowVector4d no_column(5, 6, 7, 8);
    WidePoints x(n + 1, 4);
    x << b, Vector::Zero(n), no_column;
    solver.solve(system.symbolic, x);
    const Points solution = x.topLeftCorner(n, 3);
    // Q's condition is below 3000, b of size 1.
    CHECK((system.Q * solution - b).cwiseAbs().maxCoeff() < 1e-12);
    CHECK(x.col(3).head(n) == Vector::Zero(n));
    CHECK(x.row(n) == no_column);
    RoughPoints rough(n + 1, 4);
    rough << b.cast<float>(), Eigen::VectorXf::Zero(n), no_column.cast<float>();
    solver.solve(system.symbolic, rough);
    // Seven digits, of which the condition may cost three or four.
    CHECK((rough.cast<double>() - x).cwiseAbs().maxCoeff() < 1e-3 * x.cwiseAbs().maxCoeff());
    CHECK(rough.row(n) == no_column.cast<float>());
  }
}

TEST_CASE("of no columns there is nothing to solve") {
  const Graph graph;
  const SymbolicCholesky symbolic =
      symbolic_cholesky(graph, elimination_order(Points(0, 3), graph));
  BlockSolver solver;
  CHECK(solver.factorise(symbolic, 1, Vector(), ignore));
  WidePoints x;
  solver.solve(symbolic, x);
  CHECK(symbolic.values == 0);
}

TEST_CASE("what is not positive definite is refused") {
  TestSystem system(flag(4, 4, 1));
  BlockSolver solver;
  for (const double bad : {-1.0, std::nan(""), HUGE_VAL}) {
    system.diagonal(9) = bad;
    CHECK_FALSE(solver.factorise(system.symbolic, 1, system.diagonal, ignore));
  }
}

TEST_CASE("a factorisation tells how far it is") {
  // Long enough for several reports.
  const TestSystem system(random_scene(600, 30000, 0, 17));
  std::vector<double> fractions;
  BlockSolver solver;
  CHECK(solver.factorise(system.symbolic, 1, system.diagonal,
                         [&](double fraction) { fractions.push_back(fraction); }));
  REQUIRE(fractions.size() >= 2);
  CHECK(std::is_sorted(fractions.begin(), fractions.end()));
  CHECK(fractions.front() > 0);
  CHECK(fractions.back() <= 1);
}

}  // namespace mass_spring
