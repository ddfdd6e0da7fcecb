#pragma once

#include "precomputation.h"
#include "time_step.h"

namespace mass_spring {

/// The parts of row i of Q p = b, b = k Aᵀ d + y, N.
struct VertexProbe {
  Eigen::RowVector3d y, kAtd, b, Qp;
};

/// @param iterate  p and d
/// @param y  #V by 3, N
/// @param i  a vertex
template <typename Matrix, typename Cholesky>
VertexProbe vertex_probe(const TimeStep& step,
                         const Precomputation<Matrix, Cholesky>& precomputation,
                         const Iterate& iterate, const Points& y, int i);

}  // namespace mass_spring
