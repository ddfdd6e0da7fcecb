#pragma once

#include <vector>

#include "numeric_cholesky.h"
#include "symbolic_cholesky.h"
#include "wide_point.h"

namespace mass_spring {

/// Q⁻¹ by blocks. With L_CC the triangle of a panel, L_RC what lies below it and x_C, x_R their
/// rows of x, the panel keeps D = (L_CC L_CCᵀ)⁻¹ and G = -L_RC L_CC⁻¹, so that both sweeps
///   forward:  x_R ← x_R + G x_C
///   backward: x_C ← D x_C + Gᵀ x_R
/// are products, in which no row waits for the one before.
class BlockSolver {
 public:
  /// @param coupling  N/m: the entries of Q off its diagonal are -coupling where an edge is
  /// @param diagonal  #columns, N/m: of P Q Pᵀ
  /// @return whether Q is positive definite as far as the arithmetic can tell
  bool factorise(const SymbolicCholesky& symbolic, double coupling, const Vector& diagonal,
                 const Progress& progress);

  /// x ← (P Q Pᵀ)⁻¹ x, with the panels in doubles or in floats.
  /// @param symbolic  of the factorisation
  /// @param x  #columns or more; rows that are no columns keep their values
  void solve(const SymbolicCholesky& symbolic, WidePoints& x);
  void solve(const SymbolicCholesky& symbolic, RoughPoints& x);

 private:
  template <typename Scalar>
  struct Sweeps {
    void solve(const SymbolicCholesky& symbolic, WideRows<Scalar>& x);

    // For every supernode [D; G], (width + height) by width, in strips of 4 columns (the last one
    // may be narrower), each strip row-major: both sweeps read them from beginning to end.
    std::vector<Scalar> panels;
    WideRows<Scalar> gathered;  // rows of the widest panel: scratch
  };

  Sweeps<double> doubles_;
  Sweeps<float> floats_;
};

}  // namespace mass_spring
