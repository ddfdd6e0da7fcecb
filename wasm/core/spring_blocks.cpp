#include "spring_blocks.h"

#include <algorithm>
#include <utility>

#include "matrix_from_triplets.h"
#include "same_set.h"

namespace mass_spring {

void SpringBlocks::analyse(const Edges& E, int n, const Indices& fixed) {
  E_ = E;
  fixed_ = fixed;
  unknown_.setZero(n);
  for (const int i : fixed) unknown_(i) = -1;
  int unknowns = 0;
  for (int& unknown : unknown_) {
    if (unknown == 0) unknown = std::exchange(unknowns, unknowns + 3);
  }

  Triplets pattern;
  const auto add_block = [&](int row, int column) {
    if (row < 0 || column < 0) return;
    for (int r = 0; r < 3; ++r) {
      for (int c = 0; c < 3; ++c) pattern.emplace_back(row + r, column + c, 0);
    }
  };
  for (const int unknown : unknown_) add_block(unknown, unknown);
  for (int e = 0; e < E.rows(); ++e) {
    const int i = unknown_(E(e, 0)), j = unknown_(E(e, 1));
    add_block(i, j);
    add_block(j, i);
  }
  matrix_from_triplets(unknowns, unknowns, pattern, matrix_);

  of_vertex_.clear();
  for (const int unknown : unknown_) of_vertex_.push_back(place_of(unknown, unknown));
  of_spring_.clear();
  for (int e = 0; e < E.rows(); ++e) {
    const int i = unknown_(E(e, 0)), j = unknown_(E(e, 1));
    of_spring_.push_back({place_of(i, i), place_of(j, j), place_of(i, j), place_of(j, i)});
  }
}

bool SpringBlocks::fits(const Edges& E, int n, const Indices& fixed) const {
  return unknown_.size() == n && E_.rows() == E.rows() && E_ == E && same_set(fixed_, fixed);
}

SpringBlocks::Place SpringBlocks::place_of(int row, int column) const {
  if (row < 0 || column < 0) return nowhere;
  Place place;
  const int* const rows = matrix_.innerIndexPtr();
  for (int c = 0; c < 3; ++c) {
    const int* const begin = rows + matrix_.outerIndexPtr()[column + c];
    const int* const end = rows + matrix_.outerIndexPtr()[column + c + 1];
    place[c] = static_cast<int>(std::lower_bound(begin, end, row) - rows);
  }
  return place;
}

void SpringBlocks::set_zero() { std::fill_n(matrix_.valuePtr(), matrix_.nonZeros(), 0.0); }

void SpringBlocks::add(const Place& place, const Eigen::Matrix3d& block) {
  if (place == nowhere) return;
  for (int c = 0; c < 3; ++c) {
    Eigen::Map<Eigen::Vector3d>(matrix_.valuePtr() + place[c]) += block.col(c);
  }
}

void SpringBlocks::add_spring(int e, const Eigen::Matrix3d& block) {
  const auto& [ii, jj, ij, ji] = of_spring_[e];
  add(ii, block);
  add(jj, block);
  add(ij, -block);
  add(ji, -block);
}

void SpringBlocks::add_vertex(int i, double value) {
  const Place& place = of_vertex_[i];
  if (place == nowhere) return;
  for (int c = 0; c < 3; ++c) matrix_.valuePtr()[place[c] + c] += value;
}

void SpringBlocks::gather(const Points& x, Vector& b) const {
  b.resize(matrix_.rows());
  for (int i = 0; i < unknown_.size(); ++i) {
    if (unknown_(i) >= 0) b.segment<3>(unknown_(i)) = x.row(i);
  }
}

void SpringBlocks::scatter(const Vector& b, Points& x) const {
  for (int i = 0; i < unknown_.size(); ++i) {
    if (unknown_(i) >= 0) x.row(i) = b.segment<3>(unknown_(i));
  }
}

}  // namespace mass_spring
