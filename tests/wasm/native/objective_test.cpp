#include "objective.h"

#include <doctest/doctest.h>

#include "external_energy.h"
#include "gradient.h"
#include "inertia.h"
#include "local_step.h"
#include "pin_energy.h"
#include "potential_energy.h"
#include "projection_energy.h"
#include "support.h"

namespace mass_spring {
namespace {

/// The corner with vertex 0 pulled from (0, 0, 0) to (-1, 0, 0) and the pinned vertex 2 from (3, 4,
/// 0) to (3, 4, 2).
Points pulled() {
  Points p = corner().p_curr;
  p(0, 0) = -1;
  p(2, 2) = 2;
  return p;
}

}  // namespace

TEST_CASE("every energy term, by hand") {
  TimeStep step = corner();
  const Points p = pulled();
  // Spring (0, 1) is stretched by 1: ½·10·1² = 5; spring (2, 1) has length √20 instead of 4.
  const double stretch = std::sqrt(20.0) - 4;
  CHECK(potential_energy(step.E, step.k, step.r, p) == doctest::Approx(5 + 5 * stretch * stretch));
  // 1/(2·0.25) (1·1² + 4·2²) = 34
  CHECK(inertia(step.m, step.delta_t, step.p_prev, step.p_curr, p) == 34);
  // Had the vertices come from p already, -(p - p) + p^{t-Δt} would be left.
  CHECK(inertia(step.m, step.delta_t, p, p, p) == 0);
  // -(-1·7)
  step.f_ext(0, 0) = 7;
  CHECK(external_energy(step.f_ext, p) == 7);
  // ½·100·2²
  CHECK(pin_energy(step.pinned, step.targets, step.w, p) == 200);

  const Objective E = objective(step, p);
  CHECK(E.objective == E.potential + E.inertia + E.external + E.pin);
  CHECK(E.objective == doctest::Approx(5 + 5 * stretch * stretch + 34 + 7 + 200));
}

TEST_CASE(
    "the surrogate's spring term touches the potential at the projection and lies above "
    "elsewhere") {
  const TimeStep step = corner();
  const Points p = pulled();
  Points d;
  local_step(step.E, step.r, p, d);
  const double potential = potential_energy(step.E, step.k, step.r, p);
  // Both are sums of a few squares: their rounding is a few 1e-16.
  CHECK(projection_energy(step.E, step.k, d, p) == doctest::Approx(potential).epsilon(1e-14));
  local_step(step.E, step.r, step.p_curr, d);
  CHECK(projection_energy(step.E, step.k, d, p) > potential);
}

TEST_CASE("the gradient, by hand") {
  TimeStep step = corner();
  step.f_ext(1, 1) = -5;
  Points p = step.p_curr;
  p(0, 0) = -1;
  Points g;
  gradient(step, p, g);
  Points by_hand(3, 3);
  by_hand << -10 * 1 - 1 / 0.25, 0, 0,  // its spring pulls it back, and so does inertia
      10, 5, 0,                         // the spring's other end, and - f^ext
      0, 0, 0;
  CHECK(g.isApprox(by_hand, 1e-15));
}

TEST_CASE("the gradient of a collapsed spring is finite") {
  const TimeStep step = corner();
  Points p = step.p_curr;
  p.row(0) = p.row(1);
  Points g;
  gradient(step, p, g);
  // d = (3, 0, 0): the spring pushes vertex 0 along +x, so E falls along it; inertia pulls back 3
  // m.
  CHECK(g.row(0).isApprox(Eigen::RowVector3d(-10 * 3 + 3 / 0.25, 0, 0), 1e-15));
}

}  // namespace mass_spring
