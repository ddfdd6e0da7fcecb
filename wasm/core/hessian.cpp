#include "hessian.h"

#include "edge_lengths.h"
#include "local_step.h"
#include "spring_direction.h"

namespace mass_spring {
namespace {

void add_block(Triplets& H, int i, int j, const Eigen::Matrix3d& block) {
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      H.emplace_back(3 * i + row, 3 * j + column, block(row, column));
    }
  }
}

void add_diagonal(Triplets& H, int i, double value) {
  for (int c = 0; c < 3; ++c) H.emplace_back(3 * i + c, 3 * i + c, value);
}

}  // namespace

namespace {

/// Calls of_spring(e, block) and of_vertex(i, value) with all that H consists of.
template <typename OfSpring, typename OfVertex>
void for_terms(const TimeStep& step, const Points& p, double left_out, OfSpring of_spring,
               OfVertex of_vertex) {
  Vector l;  // #E, m
  Points n;  // #E by 3: directions, projections to the length 1
  edge_lengths(p, step.E, l);
  local_step(step.E, Vector::Ones(step.E.rows()), p, n);
  for (int e = 0; e < step.E.rows(); ++e) {
    double across = step.r(e) == 0 ? 1 : 1 - step.r(e) / l(e);
    if (across < 0) across = left_out == 1 ? 0 : (1 - left_out) * across;
    const Eigen::Matrix3d nnT = n.row(e).transpose() * n.row(e);
    Eigen::Matrix3d block = step.k * (nnT + across * (Eigen::Matrix3d::Identity() - nnT));
    if (step.damping > 0) {
      const Eigen::Vector3d at_start =
          spring_direction(step.p_curr.row(step.E(e, 0)), step.p_curr.row(step.E(e, 1)));
      block += step.damping / step.delta_t * at_start * at_start.transpose();
    }
    of_spring(e, block);
  }
  for (int i = 0; i < step.m.size(); ++i) of_vertex(i, step.m(i) / (step.delta_t * step.delta_t));
  for (const int i : step.pinned) of_vertex(i, step.w);
  for (const int i : step.pull.vertices) of_vertex(i, step.pull.k);
}

}  // namespace

Triplets hessian(const TimeStep& step, const Points& p, double left_out) {
  Triplets H;
  H.reserve(36 * step.E.rows() + 3 * (step.m.size() + step.pinned.size()));
  const auto add_spring = [&](int e, const Eigen::Matrix3d& block) {
    const int i = step.E(e, 0), j = step.E(e, 1);
    add_block(H, i, i, block);
    add_block(H, j, j, block);
    add_block(H, i, j, -block);
    add_block(H, j, i, -block);
  };
  for_terms(step, p, left_out, add_spring, [&](int i, double value) { add_diagonal(H, i, value); });
  return H;
}

void fill_in_hessian(const TimeStep& step, const Points& p, double left_out, SpringBlocks& H) {
  H.set_zero();
  for_terms(
      step, p, left_out, [&](int e, const Eigen::Matrix3d& block) { H.add_spring(e, block); },
      [&](int i, double value) { H.add_vertex(i, value); });
}

}  // namespace mass_spring
