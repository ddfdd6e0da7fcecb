#include <doctest/doctest.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "elimination.h"
#include "matrix_from_triplets.h"
#include "matrix_in_order.h"
#include "ordering.h"
#include "random_scene.h"
#include "sparse_cholesky.h"
#include "support.h"
#include "system_matrix.h"
#include "system_matrix_terms.h"

namespace mass_spring {
namespace {

Triplets system_matrix_of(const TimeStep& step) {
  return system_matrix(step.E, step.k, step.m, step.delta_t, step.pinned, step.w);
}

std::vector<int> numbered(int n) {
  std::vector<int> order(n);
  std::iota(order.begin(), order.end(), 0);
  return order;
}

/// 1 wherever two vertices are joined, and on the diagonal enough to be positive definite.
Triplets matrix_of(int n, const std::vector<std::array<int, 2>>& edges) {
  Triplets Q;
  for (int i = 0; i < n; ++i) Q.emplace_back(i, i, n);
  for (const auto& [i, j] : edges) {
    Q.emplace_back(i, j, -1);
    Q.emplace_back(j, i, -1);
  }
  return Q;
}

std::vector<EliminatedEntry> after(const Elimination& elimination, int columns) {
  std::vector<EliminatedEntry> entries;
  REQUIRE(elimination.after(columns, entries).ok());
  return entries;
}

DenseMatrix dense(int n, const std::vector<EliminatedEntry>& entries) {
  DenseMatrix matrix = DenseMatrix::Zero(n, n);
  for (const EliminatedEntry& entry : entries) matrix(entry.row, entry.column) = entry.value;
  return matrix;
}

bool same(const EliminatedEntry& a, const EliminatedEntry& b) {
  return a.row == b.row && a.column == b.column && a.value == b.value && a.born == b.born;
}

/// Of springs anywhere, so that many orders fill in; w of the size of the other terms, so that
/// tolerances mean something.
TimeStep random_step(unsigned seed) {
  TimeStep step = random_scene(30, 45, 3, seed).step;
  step.w = 10 * step.k;
  return step;
}

}  // namespace

TEST_CASE("a matrix in another order, and a part of one") {
  const Triplets Q = {{0, 0, 1.0}, {1, 1, 2.0}, {2, 2, 3.0}, {0, 2, 5.0}, {2, 0, 5.0}};
  DenseMatrix ordered(2, 2);
  ordered << 3, 5, 5, 1;
  CHECK(DenseMatrix(matrix_in_order(Q, {2, 0})) == ordered);
  CHECK(matrix_in_order(Q, {}).rows() == 0);
}

TEST_CASE("two columns by hand") {
  // [4 2; 2 10] = L Lᵀ with L = [2 0; 1 3].
  const Elimination elimination({{0, 0, 4.0}, {0, 1, 2.0}, {1, 0, 2.0}, {1, 1, 10.0}}, {0, 1});
  DenseMatrix lower(2, 2);
  lower << 4, 0, 2, 10;
  CHECK(dense(2, after(elimination, 0)) == lower);
  lower << 2, 0, 1, 9;
  CHECK(dense(2, after(elimination, 1)) == lower);
  lower << 2, 0, 1, 3;
  CHECK(dense(2, after(elimination, 2)) == lower);
  // Two roots, a division, a multiplication and a subtraction.
  CHECK(elimination.flops() == 5);
}

TEST_CASE("L Lᵀ = P Q Pᵀ in every order, and L is the one that Eigen finds") {
  for (unsigned seed = 0; seed < 10; ++seed) {
    const Triplets Q = system_matrix_of(random_step(seed));
    SparseCholesky solver;
    REQUIRE(solver.factorise(30, Q));
    for (const Ordering ordering :
         {Ordering::natural, Ordering::minimum_degree, Ordering::solver}) {
      Elimination elimination(Q, ordered_unknowns(ordering, Q, solver.order()));
      const DenseMatrix PQPt = matrix_in_order(Q, elimination.order());
      const std::vector<EliminatedEntry> entries = after(elimination, 30);
      const DenseMatrix L = dense(30, entries);
      // Each entry is a sum of up to 30 products that add up to at most a diagonal entry of Q.
      const double rounding = 30 * 2e-16 * PQPt.cwiseAbs().maxCoeff();
      CHECK((L * L.transpose() - PQPt).cwiseAbs().maxCoeff() < rounding);
      CHECK(elimination.factorise());
      CHECK(static_cast<std::int64_t>(entries.size()) == elimination.tree().nonzeros);
      const auto filled = [](const EliminatedEntry& entry) { return entry.born > 0; };
      CHECK(std::count_if(entries.begin(), entries.end(), filled) == elimination.fill());
    }
  }
}

TEST_CASE("backwards every entry is as it was, and what is finished stays") {
  const Triplets Q = system_matrix_of(random_step(11));
  const Elimination elimination(Q, numbered(30));
  const std::vector<EliminatedEntry> L = after(elimination, 30);
  std::vector<std::vector<EliminatedEntry>> forwards;
  for (int columns = 0; columns <= 30; ++columns) forwards.push_back(after(elimination, columns));
  for (int columns = 30; columns >= 0; --columns) {
    const std::vector<EliminatedEntry> now = after(elimination, columns);
    CHECK(std::equal(now.begin(), now.end(), forwards[columns].begin(), forwards[columns].end(),
                     same));
    // As of L, born tells what stands here; and the columns that are eliminated are those of L.
    std::vector<EliminatedEntry> standing;
    for (const EliminatedEntry& entry : L) {
      if (entry.born <= columns) standing.push_back(entry);
    }
    REQUIRE(standing.size() == now.size());
    for (std::size_t t = 0; t < now.size(); ++t) {
      CHECK(now[t].born == standing[t].born);
      CHECK(now[t].row == standing[t].row);
      CHECK(now[t].column == standing[t].column);
      if (now[t].column < columns) CHECK(now[t].value == standing[t].value);
    }
  }
}

TEST_CASE("what remains is the Schur complement") {
  const Triplets Q = system_matrix_of(random_step(12));
  const DenseMatrix full = matrix_in_order(Q, numbered(30));
  const Elimination elimination(Q, numbered(30));
  for (const int columns : {1, 13, 29}) {
    const int rest = 30 - columns;
    const DenseMatrix complement =
        full.bottomRightCorner(rest, rest) -
        full.bottomLeftCorner(rest, columns) *
            full.topLeftCorner(columns, columns).llt().solve(full.topRightCorner(columns, rest));
    const DenseMatrix now = dense(30, after(elimination, columns)).bottomRightCorner(rest, rest);
    const DenseMatrix lower = complement.triangularView<Eigen::Lower>();
    // Q's condition number is below 1e4 here.
    CHECK((now - lower).cwiseAbs().maxCoeff() < 1e4 * 2e-16 * full.cwiseAbs().maxCoeff());
  }
}

TEST_CASE("a chain does not fill in; a star does by its centre first, by its centre last not") {
  const Elimination chain(matrix_of(6, {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 5}}), numbered(6));
  CHECK(chain.fill() == 0);
  CHECK(chain.tree().parent == std::vector<int>{1, 2, 3, 4, 5, -1});

  const Triplets star = matrix_of(6, {{0, 1}, {0, 2}, {0, 3}, {0, 4}, {0, 5}});
  const Elimination centre_first(star, {0, 1, 2, 3, 4, 5});
  CHECK(centre_first.tree().nonzeros == 21);  // all of 6 by 6
  CHECK(centre_first.fill() == 10);           // the ends, each with each
  for (const EliminatedEntry& entry : after(centre_first, 6)) {
    CHECK(entry.born == (entry.column > 0 && entry.row > entry.column ? 1 : 0));
  }
  const Elimination centre_last(star, {1, 2, 3, 4, 5, 0});
  CHECK(centre_last.fill() == 0);
  CHECK(centre_last.tree().parent == std::vector<int>{5, 5, 5, 5, 5, -1});
  CHECK(centre_last.flops() == 5 * 4 + 1);
}

TEST_CASE("the parent of a column is the first row below its diagonal") {
  for (unsigned seed = 0; seed < 5; ++seed) {
    const Elimination elimination(system_matrix_of(random_step(seed)), numbered(30));
    std::vector<int> first(30, -1);
    for (const EliminatedEntry& entry : after(elimination, 30)) {
      if (entry.row > entry.column && first[entry.column] < 0) first[entry.column] = entry.row;
    }
    CHECK(elimination.tree().parent == first);
  }
}

TEST_CASE("minimum degree is the order that Eigen's solver takes by itself") {
  for (unsigned seed = 0; seed < 5; ++seed) {
    const Triplets Q = system_matrix_of(random_step(seed));
    SparseCholesky solver;
    REQUIRE(solver.factorise(30, Q));
    CHECK(ordered_unknowns(Ordering::minimum_degree, Q, numbered(30)) == solver.order());
  }
}

TEST_CASE("orders are of the unknowns, whichever these are") {
  const Triplets Q = matrix_of(4, {{0, 1}, {1, 2}, {2, 3}});
  CHECK(ordered_unknowns(Ordering::natural, Q, {3, 0, 2}) == std::vector<int>{0, 2, 3});
  CHECK(ordered_unknowns(Ordering::solver, Q, {3, 0, 2}) == std::vector<int>{3, 0, 2});
  std::vector<int> by_degree = ordered_unknowns(Ordering::minimum_degree, Q, {3, 0, 2});
  std::sort(by_degree.begin(), by_degree.end());
  CHECK(by_degree == std::vector<int>{0, 2, 3});
  CHECK(ordered_unknowns(Ordering::minimum_degree, Q, {}).empty());
}

TEST_CASE("nothing to eliminate is no trouble") {
  Elimination nothing(matrix_of(2, {{0, 1}}), {});
  CHECK(nothing.factorise());
  CHECK(nothing.flops() == 0);
  CHECK(after(nothing, 0).empty());
}

TEST_CASE("what cannot be eliminated is refused") {
  std::vector<EliminatedEntry> entries;
  const Elimination two(matrix_of(2, {{0, 1}}), {0, 1});
  for (const int columns : {-1, 3}) {
    const Status status = two.after(columns, entries);
    CHECK(status.code == StatusCode::index_out_of_range);
    CHECK(status.value == columns);
  }
  Elimination indefinite({{0, 0, 1.0}, {0, 1, 2.0}, {1, 0, 2.0}, {1, 1, 1.0}}, {0, 1});
  CHECK(indefinite.after(2, entries).code == StatusCode::factorisation_failed);
  CHECK_FALSE(indefinite.factorise());
  CHECK(entries.empty());

  // A star of 1,200 vertices, its centre first: every later column is full, Σ c² ≈ 1200³/3.
  std::vector<std::array<int, 2>> edges;
  for (int i = 1; i < 1200; ++i) edges.push_back({0, i});
  Elimination large(matrix_of(1200, edges), numbered(1200));
  const Status status = large.after(1, entries);
  CHECK(status.code == StatusCode::too_large);
  CHECK(status.value == large.flops());
  CHECK(status.value > status.limit);
  CHECK_FALSE(large.factorise());
  CHECK(large.fill() == 1199 * 1198 / 2);
}

TEST_CASE("the terms of Q, as products of matrices, add up to its triplets") {
  for (unsigned seed = 0; seed < 5; ++seed) {
    const TimeStep step = random_step(seed);
    const SystemMatrixTerms terms = system_matrix_terms(step);
    DenseMatrix Q;
    matrix_from_triplets(30, 30, system_matrix_of(step), Q);
    const DenseMatrix sum =
        DenseMatrix(terms.springs) + DenseMatrix(terms.masses) + DenseMatrix(terms.pins);
    // A diagonal entry adds up to some ten numbers in another order.
    CHECK((sum - Q).cwiseAbs().maxCoeff() < 10 * 2.3e-16 * Q.cwiseAbs().maxCoeff());
    // A moves with all vertices: A 1 = 0, in whole numbers.
    CHECK(terms.AtA * Vector::Ones(30) == Vector::Zero(30));
    CHECK(Vector(terms.AtA.diagonal()).sum() == 2 * step.E.rows());
  }
}

}  // namespace mass_spring
