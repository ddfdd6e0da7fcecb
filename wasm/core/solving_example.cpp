#include "solving_example.h"

#include <Eigen/LU>
#include <utility>
#include <vector>

#include "matrix_from_triplets.h"
#include "system_matrix.h"
#include "triplets_from_matrix.h"

namespace mass_spring {

SolvingExample::SolvingExample(int side) {
  const int n = side * side;
  std::vector<std::pair<int, int>> springs;
  for (int row = 0; row < side; ++row) {
    for (int column = 0; column < side; ++column) {
      const int here = row * side + column;
      if (column + 1 < side) springs.push_back({here, here + 1});
      if (row + 1 < side) springs.push_back({here, here + side});
    }
  }
  Edges E(springs.size(), 2);
  for (int e = 0; e < E.rows(); ++e) E.row(e) << springs[e].first, springs[e].second;
  Indices pinned(2);
  pinned << 0, side - 1;
  // 1000 N/m, 1 kg, 1/30 s: as in the net.
  Q_ = system_matrix(E, 1e3, Vector::Ones(n), 1.0 / 30, pinned, 1e10);
  b_ = Points::Constant(n, 3, -9.8);
}

SolvingExample::SolvingExample(const SparseMatrix& Q)
    : Q_(triplets_from_matrix(Q)), b_(Points::Constant(Q.rows(), 3, -9.8)) {}

bool SolvingExample::dense_inverse() {
  if (!fits_dense()) return false;
  DenseMatrix Q;
  matrix_from_triplets(vertex_count(), vertex_count(), Q_, Q);
  inverse_ = Q.inverse();
  return true;
}

bool SolvingExample::dense_factorise() {
  return fits_dense() && dense_.factorise(vertex_count(), Q_);
}

bool SolvingExample::dense_substitute() {
  if (!fits_dense()) return false;
  dense_.solve(b_, scratch_, p_);
  return true;
}

// Of no unknowns Eigen asserts that there are some.
void SolvingExample::sparse_factorise() {
  if (vertex_count() > 0) sparse_.factorise(vertex_count(), Q_);
}

void SolvingExample::sparse_substitute() {
  if (vertex_count() > 0) sparse_.solve(b_, scratch_, p_);
}

double SolvingExample::dense_bytes() const {
  return sizeof(double) * static_cast<double>(vertex_count()) * vertex_count();
}

double SolvingExample::sparse_matrix_bytes() const {
  SparseMatrix Q;
  matrix_from_triplets(vertex_count(), vertex_count(), Q_, Q);
  return static_cast<double>(Q.nonZeros()) * (sizeof(double) + sizeof(int));
}

double SolvingExample::sparse_factor_bytes() const {
  return vertex_count() > 0 ? sparse_.bytes() : 0;
}

double SolvingExample::residual() const {
  SparseMatrix Q;
  matrix_from_triplets(vertex_count(), vertex_count(), Q_, Q);
  return (Q * p_ - b_).cwiseAbs().maxCoeff();
}

}  // namespace mass_spring
