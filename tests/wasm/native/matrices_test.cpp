#include <doctest/doctest.h>

#include "mass_matrix.h"
#include "matrix_from_triplets.h"
#include "selection_matrix.h"
#include "signed_incidence_matrix_dense.h"
#include "signed_incidence_matrix_sparse.h"
#include "support.h"
#include "system_matrix.h"
#include "triplets_from_matrix.h"

namespace mass_spring {

TEST_CASE("A has +1 at the first and -1 at the second end of every spring") {
  DenseMatrix A;
  signed_incidence_matrix_dense(3, corner().E, A);
  DenseMatrix by_hand(2, 3);
  by_hand << 1, -1, 0, 0, -1, 1;
  CHECK(A == by_hand);
}

TEST_CASE("dense and sparse hold the same numbers") {
  const TimeStep step = corner();
  DenseMatrix dense;
  SparseMatrix sparse;
  signed_incidence_matrix_dense(3, step.E, dense);
  signed_incidence_matrix_sparse(3, step.E, sparse);
  CHECK(DenseMatrix(sparse) == dense);
  CHECK(sparse.nonZeros() == 4);

  const Triplets Q = system_matrix(step.E, step.k, step.m, step.delta_t, step.pinned, step.w);
  matrix_from_triplets(3, 3, Q, dense);
  matrix_from_triplets(3, 3, Q, sparse);
  CHECK(DenseMatrix(sparse) == dense);
  CHECK(sparse.nonZeros() == 7);
}

TEST_CASE("Q = kAᵀA + M/Δt² + wCᵀC") {
  const TimeStep step = corner();
  DenseMatrix A, M, C, Q;
  signed_incidence_matrix_dense(3, step.E, A);
  matrix_from_triplets(3, 3, mass_matrix(step.m), M);
  matrix_from_triplets(1, 3, selection_matrix(step.pinned), C);
  matrix_from_triplets(3, 3,
                       system_matrix(step.E, step.k, step.m, step.delta_t, step.pinned, step.w), Q);
  // Whole numbers all: equal to the last bit.
  CHECK(Q == step.k * A.transpose() * A + M / 0.25 + step.w * C.transpose() * C);
  DenseMatrix by_hand(3, 3);
  by_hand << 10 + 4, -10, 0, -10, 20 + 8, -10, 0, -10, 10 + 16 + 100;
  CHECK(Q == by_hand);
}

TEST_CASE("a scene without springs or pins has matrices without rows") {
  SparseMatrix A;
  signed_incidence_matrix_sparse(2, Edges(0, 2), A);
  CHECK(A.rows() == 0);
  CHECK(A.cols() == 2);
  CHECK(selection_matrix(Indices(0)).empty());
}

TEST_CASE("a matrix gives back the triplets it was made of") {
  const Triplets triplets = {{0, 0, 2.0}, {1, 1, -3.0}};
  DenseMatrix dense;
  SparseMatrix sparse;
  matrix_from_triplets(2, 3, triplets, dense);
  matrix_from_triplets(2, 3, triplets, sparse);
  for (const Triplets& again : {triplets_from_matrix(dense), triplets_from_matrix(sparse)}) {
    REQUIRE(again.size() == 2);
    CHECK(again[1].row() == 1);
    CHECK(again[1].col() == 1);
    CHECK(again[1].value() == -3);
  }
}

}  // namespace mass_spring
