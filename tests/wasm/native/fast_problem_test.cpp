#include "fast_problem.h"

#include "anderson.h"
#include "chebyshev.h"
#include "lbfgs.h"
#include "local_global.h"
#include "methods_support.h"
#include "objective.h"
#include "plain_problem.h"

#define FAST_METHODS \
  LocalGlobal<FastProblem>, Chebyshev<FastProblem>, Anderson<FastProblem>, Lbfgs<FastProblem>

namespace mass_spring {
namespace {

FastSystem prepared(const TimeStep& step) {
  FastSystem system;
  system.analyse(step.p_curr, step.E, step.r, step.pinned);
  REQUIRE(system.factorise(step, [](double) {}));
  system.begin(step);
  return system;
}

TimeStep stiff_cloth(double kappa, unsigned seed) {
  return crumpled(with_stiffness_number(cloth(5, 6), kappa), seed);
}

/// p after so many iterations from p^t.
template <template <typename> class Method>
Points fast(const TimeStep& step, int iterations) {
  FastSystem system = prepared(step);
  FastProblem problem(system);
  Method<FastProblem> method;
  WidePoints field = problem.field_from_points(step.p_curr);
  method.begin(problem, field);
  for (int iteration = 0; iteration < iterations; ++iteration) method.iterate(problem, field);
  Points p;
  problem.points_from_field(field, p);
  return p;
}

template <template <typename> class Method>
Points plain(const TimeStep& step, int iterations) {
  SparsePrecomputation precomputation;
  precompute(step, precomputation);
  PlainProblem problem(step, precomputation);
  Method<decltype(problem)> method;
  Points p = step.p_curr;
  method.begin(problem, p);
  for (int iteration = 0; iteration < iterations; ++iteration) method.iterate(problem, p);
  return p;
}

}  // namespace

TEST_CASE("a field holds the pins, and gives back the points of the others") {
  TimeStep step = stiff_cloth(1, 1);
  step.targets.array() += 1;
  FastSystem system = prepared(step);
  const FastProblem problem(system);
  Points p, expected = step.p_curr;
  problem.points_from_field(problem.field_from_points(step.p_curr), p);
  expected(step.pinned, Eigen::all) = step.targets;
  CHECK(p == expected);
}

TEST_CASE_TEMPLATE("on the fast path no iteration raises the objective or moves a pin", Method,
                   FAST_METHODS) {
  for (const double kappa : {1.0, 1e2, 1e4, 1e6}) {
    CAPTURE(kappa);
    const TimeStep step = stiff_cloth(kappa, 2);
    FastSystem system = prepared(step);
    FastProblem problem(system);
    Method method;
    WidePoints field = problem.field_from_points(step.p_curr);
    method.begin(problem, field);
    const double start = method.standing().objective;
    for (int iteration = 0; iteration < 200; ++iteration) {
      const double before = method.standing().objective;
      if (!method.iterate(problem, field)) break;
      // Only the rounding of a sum of about 100 terms no greater than those at the start.
      CHECK(method.standing().objective <= before + 1e-12 * start);
    }
    CHECK(method.standing().objective < start);
    Points p;
    problem.points_from_field(field, p);
    CHECK(p(step.pinned, Eigen::all) == step.targets);
  }
}

TEST_CASE_TEMPLATE("on the fast path every method ends at the minimiser that Newton's finds",
                   Method, FAST_METHODS) {
  for (const double kappa : {1.0, 10.0}) {
    CAPTURE(kappa);
    const TimeStep step = stiff_cloth(kappa, 1);
    FastSystem system = prepared(step);
    FastProblem problem(system);
    Method method;
    WidePoints field = problem.field_from_points(step.p_curr);
    method.begin(problem, field);
    for (int iteration = 0; iteration < 400; ++iteration) method.iterate(problem, field);
    Points p;
    problem.points_from_field(field, p);
    // What objectives of about 1e4 J can tell apart (methods_test.cpp), and the drift of Newton's
    // pins, some 1000 N by w = 1e10 N/m.
    CHECK((p - minimiser(step)).cwiseAbs().maxCoeff() < 8e-7);
  }
}

TEST_CASE("on the fast path the methods make the iterates of the plain path") {
  // Each iteration magnifies rounding, and the drift of penalised pins, some 1e3 N by w = 1e10 N/m.
  const TimeStep step = stiff_cloth(10, 3);
  const auto differ = [](const Points& p, const Points& q) {
    return (p - q).cwiseAbs().maxCoeff();
  };
  CHECK(differ(fast<Lbfgs>(step, 10), plain<Lbfgs>(step, 10)) < 1e-6);
  CHECK(differ(fast<Anderson>(step, 10), plain<Anderson>(step, 10)) < 1e-6);
  CHECK(differ(fast<Chebyshev>(step, 20), plain<Chebyshev>(step, 20)) < 1e-6);
  CHECK(differ(fast<LocalGlobal>(step, 20), plain<LocalGlobal>(step, 20)) < 1e-6);
}

TEST_CASE("directions in floats cost L-BFGS no accuracy") {
  // Six penalised pins that give way to some 1e4 N lower E, 2e3 J, by 6 (1e4 N)²/2w.
  TimeStep step = stiff_cloth(100, 3);
  step.w = 1e14;
  const double in_floats = objective(step, fast<Lbfgs>(step, 300)).objective;
  const double in_doubles = objective(step, plain<Lbfgs>(step, 300)).objective;
  CHECK(std::abs(in_floats - in_doubles) < 3e-6);
}

TEST_CASE_TEMPLATE("on the fast path an iteration allocates nothing", Method, FAST_METHODS) {
  const TimeStep step = stiff_cloth(100, 1);
  FastSystem system = prepared(step);
  FastProblem problem(system);
  Method method;
  WidePoints field = problem.field_from_points(step.p_curr);
  method.begin(problem, field);
  Eigen::internal::set_is_malloc_allowed(false);
  int iterations = 0;
  while (iterations < 15 && method.iterate(problem, field)) ++iterations;
  Eigen::internal::set_is_malloc_allowed(true);
  CHECK(iterations == 15);
}

}  // namespace mass_spring
