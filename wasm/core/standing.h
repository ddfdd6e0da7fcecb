#pragma once

namespace mass_spring {

/// Where an iterative method stands, and what it has spent since it began.
/// @tparam Field  #V by 3, or the shape in which its problem holds positions
template <typename Field>
struct Standing {
  double objective = 0;  // J: E(p)
  Field gradient;        // ∂E/∂p, N
  int gradient_evaluations = 0;
  int solves = 0;  // with the factor of Q, or of Newton's Hessian
};

}  // namespace mass_spring
