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

Triplets hessian(const TimeStep& step, const Points& p, double left_out) {
  Vector l;  // #E, m
  Points n;  // #E by 3: directions, projections to the length 1
  edge_lengths(p, step.E, l);
  local_step(step.E, Vector::Ones(step.E.rows()), p, n);

  Triplets H;
  H.reserve(36 * step.E.rows() + 3 * (step.m.size() + step.pinned.size()));
  for (int e = 0; e < step.E.rows(); ++e) {
    double across = step.r(e) == 0 ? 1 : 1 - step.r(e) / l(e);
    if (across < 0) across = left_out == 1 ? 0 : (1 - left_out) * across;
    const Eigen::Matrix3d nnT = n.row(e).transpose() * n.row(e);
    Eigen::Matrix3d block = step.k * (nnT + across * (Eigen::Matrix3d::Identity() - nnT));
    const int i = step.E(e, 0), j = step.E(e, 1);
    if (step.damping > 0) {
      const Eigen::Vector3d at_start = spring_direction(step.p_curr.row(i), step.p_curr.row(j));
      block += step.damping / step.delta_t * at_start * at_start.transpose();
    }
    add_block(H, i, i, block);
    add_block(H, j, j, block);
    add_block(H, i, j, -block);
    add_block(H, j, i, -block);
  }
  for (int i = 0; i < step.m.size(); ++i) {
    add_diagonal(H, i, step.m(i) / (step.delta_t * step.delta_t));
  }
  for (const int i : step.pinned) add_diagonal(H, i, step.w);
  for (const int i : step.pull.vertices) add_diagonal(H, i, step.pull.k);
  return H;
}

}  // namespace mass_spring
