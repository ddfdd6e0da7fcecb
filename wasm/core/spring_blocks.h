#pragma once

#include <array>
#include <vector>

#include "types.h"

namespace mass_spring {

/// A symmetric matrix to which every spring contributes a 3 by 3 block B: B at (i, i) and (j, j),
/// -B at (i, j) and (j, i), and every vertex a number on its diagonal; rows and columns of fixed
/// vertices are taken out, P … Pᵀ with the P of fixed_point_constraints. Where each block goes
/// among the stored values is found once, so that filling in sorts and searches nothing.
class SpringBlocks {
 public:
  /// @param E      #E by 2
  /// @param n      #V
  /// @param fixed  #fixed
  void analyse(const Edges& E, int n, const Indices& fixed);

  /// Whether analyse() was given the same, but that the fixed vertices may be listed in another
  /// order.
  bool fits(const Edges& E, int n, const Indices& fixed) const;

  void set_zero();
  void add_spring(int e, const Eigen::Matrix3d& block);
  void add_vertex(int i, double value);

  /// Symmetric, all of it stored: #unknowns by #unknowns.
  const SparseMatrix& matrix() const { return matrix_; }

  /// P x: the rows of the vertices that are not fixed, one below the other.
  /// @param x  #V by 3
  /// @param b  #unknowns (result)
  void gather(const Points& x, Vector& b) const;
  /// The way back; rows of fixed vertices stay as they are.
  /// @param b  #unknowns
  /// @param x  #V by 3 (updated)
  void scatter(const Vector& b, Points& x) const;

 private:
  /// Where the three columns of a block begin among the values of the matrix.
  using Place = std::array<int, 3>;
  static constexpr Place nowhere = {-1, -1, -1};

  Place place_of(int row, int column) const;
  void add(const Place& place, const Eigen::Matrix3d& block);

  Edges E_;          // #E by 2
  Indices fixed_;    // #fixed
  Indices unknown_;  // #V: the first of the three of a vertex, -1 where it is fixed
  SparseMatrix matrix_;
  std::vector<std::array<Place, 4>> of_spring_;  // (i, i), (j, j), (i, j), (j, i)
  std::vector<Place> of_vertex_;                 // its diagonal
};

}  // namespace mass_spring
