#include <doctest/doctest.h>

#include <cmath>

#include "fast_mass_springs_precomputation_dense.h"
#include "fast_mass_springs_precomputation_sparse.h"
#include "fast_mass_springs_step_dense.h"
#include "fast_mass_springs_step_sparse.h"
#include "global_step.h"
#include "gradient.h"
#include "inertial_prediction.h"
#include "inertial_right_hand_side.h"
#include "local_step.h"
#include "support.h"
#include "symplectic_euler.h"
#include "system_product.h"
#include "vertex_probe.h"

namespace mass_spring {
namespace {

/// Two unit masses joined by a spring of rest length 1, stretched to 2 along x, at rest; k = 1 N/m,
/// Δt = 1 s.
TimeStep stretched() {
  TimeStep step;
  step.E.resize(1, 2);
  step.E << 1, 0;
  step.r = Vector::Ones(1);
  step.m = Vector::Ones(2);
  step.k = step.delta_t = step.w = 1;
  step.pinned.resize(0);
  step.targets.resize(0, 3);
  step.p_curr.resize(2, 3);
  step.p_curr << 0, 0, 0, 2, 0, 0;
  step.p_prev = step.p_curr;
  step.f_ext.setZero(2, 3);
  return step;
}

Points symplectic_euler(const TimeStep& step) {
  Points p;
  SymplecticEuler()(step, p);
  return p;
}

void precompute(const TimeStep& step, SparsePrecomputation& precomputation) {
  Vector r;
  REQUIRE(fast_mass_springs_precomputation_sparse(step.p_curr, step.E, step.k, step.m, step.pinned,
                                                  step.delta_t, step.w, r, precomputation));
}

}  // namespace

TEST_CASE("one iteration of a single spring, by hand") {
  const TimeStep step = stretched();
  SparsePrecomputation precomputation;
  precompute(step, precomputation);
  Workspace workspace;
  Iterate iterate;
  fast_mass_springs_step_sparse(step, precomputation, workspace, iterate, 1);
  // local: d = (1, 0, 0). global: Q = [[2 -1] [-1 2]], b = Aᵀd + p^t = (0 - 1, 2 + 1), p = Q⁻¹b =
  // (1/3, 5/3).
  CHECK(iterate.d.row(0) == Eigen::RowVector3d(1, 0, 0));
  CHECK(workspace.b.col(0) == Eigen::Vector2d(-1, 3));
  CHECK(iterate.p.col(0).isApprox(Eigen::Vector2d(1.0 / 3, 5.0 / 3), 1e-15));
  CHECK(iterate.p_before == step.p_curr);
}

TEST_CASE("precomputation measures the rest lengths") {
  const TimeStep step = corner();
  SparsePrecomputation precomputation;
  Vector r;
  REQUIRE(fast_mass_springs_precomputation_sparse(step.p_curr, step.E, step.k, step.m, step.pinned,
                                                  step.delta_t, step.w, r, precomputation));
  CHECK(r == step.r);
}

TEST_CASE("dense and sparse make the same step, of 50 iterations unless told otherwise") {
  TimeStep step = corner();
  step.f_ext.col(1).setConstant(-9.8);
  DensePrecomputation dense;
  SparsePrecomputation sparse;
  Vector r;
  REQUIRE(fast_mass_springs_precomputation_dense(step.p_curr, step.E, step.k, step.m, step.pinned,
                                                 step.delta_t, step.w, r, dense));
  precompute(step, sparse);
  Workspace workspace;
  Iterate by_dense, by_sparse, fifty;
  fast_mass_springs_step_dense(step, dense, workspace, by_dense);
  fast_mass_springs_step_sparse(step, sparse, workspace, by_sparse);
  fast_mass_springs_step_sparse(step, sparse, workspace, fifty, 50);
  // Q's condition is below 100: 14 digits remain.
  CHECK(by_dense.p.isApprox(by_sparse.p, 1e-14));
  CHECK(by_sparse.p == fifty.p);
}

TEST_CASE("an iteration allocates nothing after the first") {
  const TimeStep step = corner();
  SparsePrecomputation precomputation;
  precompute(step, precomputation);
  Workspace workspace;
  Iterate iterate;
  fast_mass_springs_step_sparse(step, precomputation, workspace, iterate, 1);
  Eigen::internal::set_is_malloc_allowed(
      false);  // from here Eigen asserts that it allocates nothing
  for (int iteration = 0; iteration < 3; ++iteration) {
    local_step(step.E, step.r, iterate.p, iterate.d);
    iterate.p.swap(iterate.p_before);
    global_step(precomputation, step.k, iterate.d, workspace, iterate.p);
  }
  Eigen::internal::set_is_malloc_allowed(true);
  CHECK(iterate.p.allFinite());
}

TEST_CASE("Q p - b is the gradient, and a vertex's probe its row") {
  const TimeStep step = corner();
  SparsePrecomputation precomputation;
  precompute(step, precomputation);
  Iterate iterate;
  iterate.p = step.p_curr.array() + 0.25;
  iterate.p(0, 1) = 2;
  local_step(step.E, step.r, iterate.p, iterate.d);
  Points y, Qp, g;
  inertial_right_hand_side(step, precomputation.M, precomputation.C, y);
  system_product(step, precomputation, iterate.p, Qp);
  gradient(step, iterate.p, g);
  for (int i = 0; i < 3; ++i) {
    const VertexProbe probe = vertex_probe(step, precomputation, iterate, y, i);
    CHECK(probe.Qp == Qp.row(i));
    // Sums of a few numbers of some hundreds.
    CHECK((probe.Qp - probe.b - g.row(i)).cwiseAbs().maxCoeff() < 1e-12);
    CHECK(probe.b == probe.kAtd + probe.y);
  }
}

TEST_CASE("the inertial prediction") {
  TimeStep step = corner();
  step.p_prev.col(0).array() -= 1;
  step.f_ext(1, 1) = -8;
  // One metre further along x, and Δt² f/m = 0.25·(-8)/2 for vertex 1.
  Points by_hand = step.p_curr;
  by_hand.col(0).array() += 1;
  by_hand(1, 1) -= 1;
  CHECK(inertial_prediction(step) == by_hand);
}

TEST_CASE("an explicit step takes the forces where the springs are, not where they will be") {
  TimeStep step = stretched();
  // The spring of 1 N/m is 1 m too long and pulls both masses of 1 kg by 1 m in 1 s.
  CHECK(symplectic_euler(step).col(0) == Vector{{1, 1}});
  step.f_ext.col(1).setConstant(-2);
  CHECK(symplectic_euler(step).col(1) == Vector{{-2, -2}});
  step.pinned = Indices::Zero(1);
  step.targets = Points::Constant(1, 3, 7);
  CHECK(symplectic_euler(step).row(0) == Eigen::RowVector3d(7, 7, 7));
}

TEST_CASE("explicit steps keep the momentum, and beyond Δt ω = 2 they blow up") {
  // Two masses on a spring swing with ω = (2k/m)^½.
  for (const double delta_t_omega : {1.9, 2.1}) {
    TimeStep step = stretched();
    step.k = 0.5 * delta_t_omega * delta_t_omega;
    step.p_curr << 0, 0, 0, 1.001, 0, 0;
    step.p_prev = step.p_curr;
    for (int t = 0; t < 100; ++t) {
      const Points next = symplectic_euler(step);
      step.p_prev = step.p_curr;
      step.p_curr = next;
    }
    // The middle stays, to the rounding of 100 additions of about 1 m; as long as nothing blows up.
    const double stretch = std::abs(step.p_curr(1, 0) - step.p_curr(0, 0) - 1);
    if (delta_t_omega < 2) {
      CHECK(step.p_curr.col(0).sum() == doctest::Approx(1.001).epsilon(1e-13));
      CHECK(stretch < 0.01);
    } else {
      CHECK(stretch > 1);
    }
  }
}

}  // namespace mass_spring
