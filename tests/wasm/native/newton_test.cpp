#include "newton.h"

#include "gradient.h"
#include "methods_support.h"
#include "objective.h"
#include "objective_change.h"
#include "support.h"

namespace mass_spring {

TEST_CASE("a change of the objective is the difference of two, with all its digits") {
  const TimeStep step = crumpled(with_stiffness_number(cloth(4, 5), 100), 3);
  const Points& p = step.p_curr;
  Points q = crumpled(step, 4).p_curr;
  const double difference = objective(step, q).objective - objective(step, p).objective;
  // Both are about w/2 0.2² J at a pin.
  CHECK(objective_change(step, p, q) == doctest::Approx(difference).epsilon(1e-12));
  CHECK(objective_change(step, q, p) == doctest::Approx(-difference).epsilon(1e-12));
  CHECK(objective_change(step, p, p) == 0);

  // A move of 1e-12 m, along which E(q) - E(p) would round to nothing but noise: the gradient says
  // what E does, up to the curvature w 1e-12² at the pins.
  Points g;
  gradient(step, p, g);
  const Points move = -1e-12 * g / g.cwiseAbs().maxCoeff();
  q = p + move;
  CHECK(objective_change(step, p, q) ==
        doctest::Approx((q - p).cwiseProduct(g).sum()).epsilon(1e-9));
}

TEST_CASE("a spring that stays collapsed changes nothing") {
  TimeStep step = corner();
  step.E.conservativeResize(1, 2);
  step.r.conservativeResize(1);
  step.p_curr.row(0) = step.p_curr.row(1);
  step.p_prev = step.p_curr;
  Points q = step.p_curr;
  q.topRows(2).col(0).array() += 1;
  // Inertia alone: 1/(2·0.25) (1 + 2) 1²
  CHECK(objective_change(step, step.p_curr, q) == 6);
}

TEST_CASE("Newton's method ends where the gradient is nothing but rounding") {
  for (const double kappa : {1.0, 1e2, 1e4, 1e6}) {
    for (const unsigned seed : {1, 2, 3}) {
      CAPTURE(kappa);
      const TimeStep step = crumpled(with_stiffness_number(cloth(5, 6), kappa), seed);
      Points g;
      gradient(step, minimiser(step), g);
      // Positions of up to 6 m are rounded by 1e-15 m at most, which w turns into 1e-5 N at a pin;
      // a spring, into k 1e-15.
      for (const int i : step.pinned) {
        CHECK(g.row(i).cwiseAbs().maxCoeff() < 1e-5);
        g.row(i).setZero();
      }
      CHECK(g.cwiseAbs().maxCoeff() < 1e-14 * (step.k * 6 + 6 / (step.delta_t * step.delta_t)));
    }
  }
}

TEST_CASE("every iteration of Newton's method lowers the objective") {
  const TimeStep step = crumpled(with_stiffness_number(cloth(5, 6), 1e5), 5);
  Newton newton;
  Points p = step.p_curr;
  newton.begin(step, p);
  CHECK(newton.standing().objective == objective(step, p).objective);
  while (true) {
    const Points before = p;
    if (!newton.iterate(step, p)) break;
    CHECK(objective_change(step, before, p) < 0);
    CHECK(newton.standing().objective == objective(step, p).objective);
  }
  CHECK(newton.standing().solves >= newton.standing().gradient_evaluations - 1);
}

TEST_CASE("Newton's method needs no more than a few iterations where E is nearly quadratic") {
  // A cloth that starts to fall: its springs are hardly longer than at rest. Quadratic convergence
  // doubles the digits in every iteration: 16 of them in about 5.
  const TimeStep step = with_stiffness_number(cloth(5, 6), 10);
  Newton newton;
  Points p = step.p_curr;
  newton.begin(step, p);
  int iterations = 0;
  while (newton.iterate(step, p)) ++iterations;
  CHECK(iterations <= 6);
}

TEST_CASE("Newton's method frees itself of a collapsed spring") {
  TimeStep step = corner();
  step.p_curr.row(0) = step.p_curr.row(1);
  const Points p = minimiser(step);
  CHECK(p.allFinite());
  CHECK(objective_change(step, step.p_curr, p) < 0);
}

}  // namespace mass_spring
