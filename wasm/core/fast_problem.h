#pragma once

#include "fast_system.h"

namespace mass_spring {

/// One time step as the methods of descent see it (descent.h), on the fast path. Lends its
/// argument.
class FastProblem {
 public:
  using Field = WidePoints;
  using Direction = RoughPoints;

  /// @param system  after begin()
  explicit FastProblem(FastSystem& system) : system_(system) {}

  /// @param p  #V by 3, m
  /// @return the same by rows, pinned vertices moved to where they are held
  Field field_from_points(const Points& p) const {
    Field field = system_.rows_from_points(p);
    system_.hold_pins(field);
    return field;
  }

  /// @param p  #V by 3, m (result)
  void points_from_field(const Field& field, Points& p) const {
    system_.points_from_rows(field, p);
  }

  /// @param p  #V rows, m: pinned vertices where they are held
  /// @param g  #V rows, N: ∂E/∂p, 0 in rows of pinned vertices (result)
  /// @return E(p) - objective_offset(), J
  double objective_and_gradient(const Field& p, Field& g) const { return system_.gradient(p, g); }

  double objective_offset() const { return system_.objective_offset(); }

  /// @param g  #V rows, N: 0 in rows of pinned vertices
  /// @param x  #V rows, m: Q⁻¹ g, 0 in rows of pinned vertices (result)
  void apply_inverse(const Field& g, Field& x) {
    x = g;
    system_.apply_inverse(x);
  }
  void apply_inverse(const Direction& g, Direction& x) {
    x = g;
    system_.apply_inverse(x);
  }

  /// N: ‖∂E/∂p‖∞ of the vertices that are not pinned.
  double gradient_norm(const Field& g) const { return g.cwiseAbs().maxCoeff(); }

 private:
  FastSystem& system_;
};

}  // namespace mass_spring
