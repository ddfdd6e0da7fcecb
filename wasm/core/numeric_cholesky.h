#pragma once

#include <functional>
#include <vector>

#include "symbolic_cholesky.h"
#include "types.h"

namespace mass_spring {

/// Told which fraction of the work is done.
using Progress = std::function<void(double fraction)>;

/// The values of L, P Q Pᵀ = L Lᵀ.
/// @param coupling  N/m: the entries of Q off its diagonal are -coupling where an edge is
/// @param diagonal  #columns, N/m: of P Q Pᵀ
/// @param values    of every panel, row-major; what lies above the diagonal means nothing (result)
/// @return whether Q is positive definite as far as the arithmetic can tell; there is no L if not
bool numeric_cholesky(const SymbolicCholesky& symbolic, double coupling, const Vector& diagonal,
                      const Progress& progress, std::vector<double>& values);

}  // namespace mass_spring
