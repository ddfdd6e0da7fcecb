#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <vector>

namespace mass_spring {

/// #rows by 3, metres (or newtons for forces): one point a row, row-major like the arrays of the
/// page.
using Points = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;
/// #E by 2: springs, zero-based indices into the vertices.
using Edges = Eigen::Matrix<int, Eigen::Dynamic, 2, Eigen::RowMajor>;
using Vector = Eigen::VectorXd;
using Indices = Eigen::VectorXi;
using DenseMatrix = Eigen::MatrixXd;
using SparseMatrix = Eigen::SparseMatrix<double>;
/// Entries (row, column, value) of a matrix; repeated ones add up.
using Triplets = std::vector<Eigen::Triplet<double>>;

}  // namespace mass_spring
