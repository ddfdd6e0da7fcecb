#pragma once

#include "dense_cholesky.h"
#include "sparse_cholesky.h"
#include "types.h"

namespace mass_spring {

/// What stays the same from time step to time step, in one of the two storages.
template <typename Matrix, typename Cholesky>
struct Precomputation {
  Matrix A;    // #E by #V: signed incidence
  Matrix M;    // #V by #V, kg: masses
  Matrix C;    // #pinned by #V: selection of the pinned vertices
  Cholesky Q;  // of Q = k AᵀA + M/Δt² + w CᵀC, #V by #V, N/m
};

using DensePrecomputation = Precomputation<DenseMatrix, DenseCholesky>;
using SparsePrecomputation = Precomputation<SparseMatrix, SparseCholesky>;

}  // namespace mass_spring
