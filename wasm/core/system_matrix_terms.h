#pragma once

#include "time_step.h"
#include "types.h"

namespace mass_spring {

/// What Q is the sum of, each #V by #V, N/m.
struct SystemMatrixTerms {
  SparseMatrix AtA;      // AᵀA, without its unit: how many springs a vertex has; -1 where one is
  SparseMatrix springs;  // k AᵀA
  SparseMatrix masses;   // M/Δt²
  SparseMatrix pins;     // w CᵀC
};

/// As products of matrices, for which system_matrix() has the entries at once.
SystemMatrixTerms system_matrix_terms(const TimeStep& step);

}  // namespace mass_spring
