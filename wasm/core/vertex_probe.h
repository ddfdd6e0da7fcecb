#pragma once

#include <vector>

#include "precomputation.h"
#include "time_step.h"

namespace mass_spring {

/// The parts of row i of Q p = b, b = k Aᵀ d + y, N.
struct VertexProbe {
  Eigen::RowVector3d y, kAtd, b, Qp;
  // What kAᵀd is the sum of: the springs at the vertex, ascending, and k d_e with the sign that A
  // has there.
  std::vector<int> springs;
  Points shares;  // #springs by 3
};

/// @param iterate  p and d
/// @param y  #V by 3, N
/// @param i  a vertex
template <typename Matrix, typename Cholesky>
VertexProbe vertex_probe(const TimeStep& step,
                         const Precomputation<Matrix, Cholesky>& precomputation,
                         const Iterate& iterate, const Points& y, int i);

}  // namespace mass_spring
