#pragma once

#include "time_step.h"
#include "types.h"

namespace mass_spring {

/// The matrix of linearly implicit Euler and what it is made of; coordinate c of vertex i is row
/// 3i + c.
struct LinearlyImplicitTerms {
  SparseMatrix K;            // ∂f/∂q, 3#V by 3#V, N/m
  SparseMatrix D;            // ∂f/∂q̇, 3#V by 3#V, N s/m: empty without damping
  SparseMatrix P;            // #unknowns by 3#V: selects the coordinates of the free vertices
  SparseMatrix system;       // M - Δt D - Δt² K, 3#V by 3#V, kg
  SparseMatrix constrained;  // P (M - Δt D - Δt² K) Pᵀ, #unknowns by #unknowns, kg
};

/// As sums and products of matrices, of which linearly_implicit_euler fills in the last at once.
/// @param q  #V by 3, m: where K and D are taken
LinearlyImplicitTerms linearly_implicit_terms(const TimeStep& step, const Points& q);

}  // namespace mass_spring
