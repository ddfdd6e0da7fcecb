#include "fast_system.h"

#include <doctest/doctest.h>

#include "bounding_box_diagonal.h"
#include "fast_mass_springs_precomputation_sparse.h"
#include "fast_mass_springs_step_sparse.h"
#include "gradient.h"
#include "objective.h"
#include "random_scene.h"

namespace mass_spring {
namespace {

void ignore(double) {}

FastSystem prepared(const TestScene& scene) {
  const TimeStep& step = scene.step;
  FastSystem system;
  system.analyse(scene.V, step.E, step.r, step.pinned);
  REQUIRE(system.factorise(step, ignore));
  system.begin(step);
  return system;
}

Points fast_step(FastSystem& system, const TimeStep& step, int iterations) {
  WidePoints rows = system.rows_from_points(step.p_curr);
  system.iterate(rows, iterations);
  Points p;
  system.points_from_rows(rows, p);
  return p;
}

Points plain_step(const TestScene& scene, int iterations) {
  const TimeStep& step = scene.step;
  SparsePrecomputation precomputation;
  Vector r;
  REQUIRE(fast_mass_springs_precomputation_sparse(scene.V, step.E, step.k, step.m, step.pinned,
                                                  step.delta_t, step.w, r, precomputation));
  Workspace workspace;
  Iterate iterate;
  fast_mass_springs_step_sparse(step, precomputation, workspace, iterate, iterations);
  return iterate.p;
}

std::vector<TestScene> scenes() {
  std::vector<TestScene> scenes;
  // In pieces, with lone vertices; none, some and all pinned; no spring; one vertex.
  for (const auto& [vertices, springs, pins] :
       {std::array{30, 20, 0}, {30, 61, 3}, {25, 150, 8}, {6, 9, 6}, {5, 0, 2}, {1, 0, 0}}) {
    scenes.push_back(random_scene(vertices, springs, pins, 23));
  }
  for (const double stiffness_number : {1.0, 1e3, 1e6}) {
    scenes.push_back(flag(13, 8, stiffness_number));
  }
  return scenes;
}

}  // namespace

TEST_CASE("its iterates are those of the plain step, pins dragged or not") {
  for (const TestScene& scene : scenes()) {
    FastSystem system = prepared(scene);
    for (const int iterations : {1, 10, 50}) {
      const Points difference =
          fast_step(system, scene.step, iterations) - plain_step(scene, iterations);
      // Solving the plain system costs up to 6 of 16 digits, the stiffness number's.
      CHECK(difference.cwiseAbs().maxCoeff() <=
            1e-9 * std::max(1.0, bounding_box_diagonal(scene.V)));
    }
  }
}

TEST_CASE("gradient and objective are the plain ones, pins held") {
  for (const TestScene& scene : scenes()) {
    const TimeStep& step = scene.step;
    const FastSystem system = prepared(scene);
    WidePoints rows = system.rows_from_points(step.p_curr), g_rows;
    system.hold_pins(rows);
    Points p, g, plain_g;
    system.points_from_rows(rows, p);
    CHECK(p(step.pinned, Eigen::all) == step.targets);
    const double fast_objective = system.gradient(rows, g_rows) + system.objective_offset();
    const Objective E = objective(step, p);
    // Sums of terms some of which cancel.
    const double terms = E.potential + E.inertia + std::abs(E.external);
    CHECK(std::abs(fast_objective - E.objective) <= 1e-13 * terms);
    system.points_from_rows(g_rows, g);
    gradient(step, p, plain_g);
    for (const int i : step.pinned) plain_g.row(i).setZero();
    CHECK((g - plain_g).cwiseAbs().maxCoeff() <= 1e-12 * (1 + plain_g.cwiseAbs().maxCoeff()));
  }
}

TEST_CASE("a collapsed spring points the same way as in the local step") {
  // One, two and three springs: alone, and first and second of a pair.
  for (const int springs : {1, 2, 3}) {
    TimeStep step;
    step.E.resize(springs, 2);
    for (int e = 0; e < springs; ++e) step.E.row(e) << 2 * e + e % 2, 2 * e + 1 - e % 2;
    step.r = Vector::LinSpaced(springs, 1, springs);
    step.m = Vector::Ones(2 * springs);
    step.k = step.delta_t = step.w = 1;
    step.targets.resize(0, 3);
    step.p_prev = step.p_curr = step.f_ext = Points::Zero(2 * springs, 3);
    const FastSystem system = prepared({step.p_curr, step});
    WidePoints g_rows;
    system.gradient(system.rows_from_points(step.p_curr), g_rows);
    Points g, plain_g;
    system.points_from_rows(g_rows, g);
    gradient(step, step.p_curr, plain_g);
    CHECK(g == plain_g);
    CHECK(plain_g.cwiseAbs().maxCoeff() == springs);
  }
}

TEST_CASE("Q^-1 undoes Q") {
  const TestScene scene = flag(13, 8, 100);
  const TimeStep& step = scene.step;
  FastSystem system = prepared(scene);
  // Springs of length 0 have d = 0, so that the gradient is Q p + constant.
  FastSystem linear;
  linear.analyse(scene.V, step.E, Vector::Zero(step.E.rows()), step.pinned);
  REQUIRE(linear.factorise(step, ignore));
  linear.begin(step);
  WidePoints p = linear.rows_from_points(step.p_curr), q = linear.rows_from_points(step.p_prev);
  linear.hold_pins(p);
  linear.hold_pins(q);
  WidePoints g, h;
  linear.gradient(p, g);
  linear.gradient(q, h);
  g -= h;
  system.apply_inverse(g);
  Points by_inverse, p_points, q_points;
  system.points_from_rows(g, by_inverse);
  system.points_from_rows(p, p_points);
  system.points_from_rows(q, q_points);
  // Q's condition is about 100, displacements some centimetres.
  CHECK((by_inverse - (p_points - q_points)).cwiseAbs().maxCoeff() < 1e-14);
}

TEST_CASE("equal input gives equal bits, and an analysis serves other values") {
  TestScene scene = flag(13, 8, 100);
  FastSystem once = prepared(scene);
  const Points first = fast_step(once, scene.step, 20);
  CHECK(fast_step(once, scene.step, 20) == first);
  FastSystem again = prepared(scene);
  CHECK(fast_step(again, scene.step, 20) == first);

  scene.step.k *= 3;
  scene.step.m *= 0.5;
  scene.step.delta_t *= 2;
  FastSystem fresh = prepared(scene);
  REQUIRE(once.factorise(scene.step, ignore));
  once.begin(scene.step);
  CHECK(fast_step(once, scene.step, 20) == fast_step(fresh, scene.step, 20));
}

TEST_CASE("the size of L is known before it is made") {
  // A chain of three, its end pinned: L has one panel of 2 by 2.
  TimeStep step;
  step.E.resize(2, 2);
  step.E << 0, 1, 2, 1;
  step.pinned.resize(1);
  step.pinned << 2;
  FastSystem system;
  system.analyse(random_points(3, 1), step.E, Vector::Ones(2), step.pinned);
  CHECK(system.bytes() == 4 * (8 + 4));
}

}  // namespace mass_spring
