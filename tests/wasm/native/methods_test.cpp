#include <cmath>
#include <vector>

#include "anderson.h"
#include "chebyshev.h"
#include "fast_mass_springs_step_sparse.h"
#include "inertial_prediction.h"
#include "lbfgs.h"
#include "local_global.h"
#include "methods_support.h"
#include "objective.h"
#include "plain_problem.h"
#include "quadratic_problem.h"
#include "stopping_rule.h"
#include "support.h"

#define PLAIN_METHODS                                                            \
  LocalGlobal<SparseProblem>, Chebyshev<SparseProblem>, Anderson<SparseProblem>, \
      Lbfgs<SparseProblem>
#define QUADRATIC_METHODS                                                                 \
  LocalGlobal<QuadraticProblem>, Chebyshev<QuadraticProblem>, Anderson<QuadraticProblem>, \
      Lbfgs<QuadraticProblem>

namespace mass_spring {
namespace {

using Field = QuadraticProblem::Field;

/// E = ¼p⁴ - ½p² with Q the identity.
struct DoubleWell {
  using Field = Eigen::MatrixXd;
  using Direction = Field;

  double objective_and_gradient(const Field& p, Field& g) const {
    g(0) = p(0) * p(0) * p(0) - p(0);
    return 0.25 * p(0) * p(0) * p(0) * p(0) - 0.5 * p(0) * p(0);
  }
  void apply_inverse(const Field& g, Field& x) const { x = g; }
};

/// p after so many iterations of a method from p^t.
template <typename Method>
Points after(int iterations, const TimeStep& step, Method method = Method()) {
  SparsePrecomputation precomputation;
  precompute(step, precomputation);
  PlainProblem problem(step, precomputation);
  Points p = step.p_curr;
  method.begin(problem, p);
  for (int iteration = 0; iteration < iterations; ++iteration) method.iterate(problem, p);
  return p;
}

/// How many iterations a method needs to bring the objective down to `objective`, J; 50 if more.
template <typename Method>
int iterations_to(double objective, const TimeStep& step) {
  SparsePrecomputation precomputation;
  precompute(step, precomputation);
  PlainProblem problem(step, precomputation);
  Method method;
  Points p = step.p_curr;
  method.begin(problem, p);
  int iterations = 0;
  while (method.standing().objective > objective && iterations < 50) {
    method.iterate(problem, p);
    ++iterations;
  }
  return iterations;
}

/// |p| after so many iterations on a quadratic objective, from |p_i| = 1.
template <typename Method>
double distance_after(int iterations, const Vector& h) {
  QuadraticProblem problem{h};
  Method method;
  Field p = Field::Zero(h.size(), 4);
  p.col(0).setOnes();
  method.begin(problem, p);
  for (int iteration = 0; iteration < iterations; ++iteration) method.iterate(problem, p);
  return p.norm();
}

}  // namespace

TEST_CASE_TEMPLATE("no iteration raises the objective", Method, PLAIN_METHODS) {
  for (const double kappa : {1.0, 1e2, 1e4, 1e6}) {
    for (const unsigned seed : {1, 2, 3}) {
      CAPTURE(kappa);
      const TimeStep step = crumpled(with_stiffness_number(cloth(5, 6), kappa), seed);
      SparsePrecomputation precomputation;
      precompute(step, precomputation);
      PlainProblem problem(step, precomputation);
      Method method;
      Points p = step.p_curr;
      method.begin(problem, p);
      const double start = method.standing().objective;
      CHECK(start == objective(step, p).objective);
      for (int iteration = 0; iteration < 200; ++iteration) {
        const double before = method.standing().objective;
        if (!method.iterate(problem, p)) break;
        // Only the rounding of a sum of about 100 terms no greater than those at the start.
        CHECK(method.standing().objective <= before + 1e-12 * start);
      }
      CHECK(method.standing().objective == objective(step, p).objective);
      CHECK(method.standing().objective < start);
    }
  }
}

TEST_CASE_TEMPLATE(
    "an accelerated iterate that would raise the objective gives way to the plain one", Method,
    Chebyshev<SparseProblem>, Anderson<SparseProblem>) {
  int rejected = 0;
  for (const double kappa : {10.0, 1e4}) {
    const TimeStep step = crumpled(with_stiffness_number(cloth(5, 6), kappa), 1);
    SparsePrecomputation precomputation;
    precompute(step, precomputation);
    PlainProblem problem(step, precomputation);
    Method method;
    Points p = step.p_curr, x;
    method.begin(problem, p);
    for (int iteration = 0; iteration < 200; ++iteration) {
      problem.apply_inverse(method.standing().gradient, x);
      const Points plain = p - x;
      const int evaluations = method.standing().gradient_evaluations;
      if (!method.iterate(problem, p)) break;
      if (method.standing().gradient_evaluations == evaluations + 1) continue;
      ++rejected;
      CHECK(p == plain);
    }
  }
  CHECK(rejected > 0);
}

TEST_CASE("L-BFGS steps along the direction of the BFGS formula") {
  QuadraticProblem problem{Vector{{0.1, 0.4, 1}}};
  Lbfgs<QuadraticProblem> method;
  Field p = Field::Zero(3, 4), g(3, 4);
  p.col(0) << 1, -2, 3;
  method.begin(problem, p);
  std::vector<Eigen::Vector3d> s, y;
  for (int iteration = 0; iteration < 4; ++iteration) {
    // H = (I - s yᵀ/sᵀy) H (I - y sᵀ/sᵀy) + s sᵀ/sᵀy for one pair after the other, from γ Q⁻¹ = γ
    // I.
    Eigen::Matrix3d H = Eigen::Matrix3d::Identity();
    if (!s.empty()) H *= s.back().dot(y.back()) / y.back().squaredNorm();
    for (std::size_t i = 0; i < s.size(); ++i) {
      const Eigen::Matrix3d V =
          Eigen::Matrix3d::Identity() - y[i] * s[i].transpose() / s[i].dot(y[i]);
      H = (V.transpose() * H * V + s[i] * s[i].transpose() / s[i].dot(y[i])).eval();
    }
    const Field before = p;
    problem.objective_and_gradient(before, g);
    REQUIRE(method.iterate(problem, p));
    s.push_back((p - before).col(0));
    y.push_back(problem.h.asDiagonal() * s.back());
    // A few products of numbers of about 1.
    CHECK((-s.back()).normalized().isApprox((H * g.col(0)).normalized(), 1e-12));
  }
}

TEST_CASE("L-BFGS keeps no pair along which the objective curves downwards") {
  // On the hill between two wells the second iteration is as plain as the first.
  DoubleWell problem;
  Lbfgs<DoubleWell> method;
  DoubleWell::Field p(1, 1);
  p << 0.125;
  method.begin(problem, p);
  for (double plain = 0.125; plain < 0.5;) {
    plain -= plain * plain * plain - plain;
    method.iterate(problem, p);
    CHECK(p(0) == plain);
  }
}

TEST_CASE_TEMPLATE("every method ends at the minimiser that Newton's finds", Method,
                   PLAIN_METHODS) {
  for (const double kappa : {1.0, 10.0}) {
    CAPTURE(kappa);
    const TimeStep step = crumpled(with_stiffness_number(cloth(5, 6), kappa), 1);
    // A method that compares objectives of about 1e4 J to 16 digits sees no difference closer than
    // (2·1e4·1e-16 / (m/Δt²))^½ = 5e-8 m to the minimum; the cloth is 6 m wide.
    CHECK((after<Method>(400, step) - minimiser(step)).cwiseAbs().maxCoeff() < 6e-7);
  }
}

TEST_CASE("p ← p - Q⁻¹ ∂E/∂p makes the iterates of local and global step") {
  for (const double kappa : {1.0, 1e3, 1e6}) {
    const TimeStep step = crumpled(with_stiffness_number(cloth(5, 6), kappa), 2);
    for (const int iterations : {1, 10, 50}) {
      CAPTURE(kappa);
      CAPTURE(iterations);
      SparsePrecomputation precomputation;
      precompute(step, precomputation);
      Workspace workspace;
      Iterate iterate;
      fast_mass_springs_step_sparse(step, precomputation, workspace, iterate, iterations);
      // Solving with Q costs the digits of κ in 16, times the 6 m of the cloth.
      const Points p = after<LocalGlobal<SparseProblem>>(iterations, step);
      CHECK((p - iterate.p).cwiseAbs().maxCoeff() < 6e-9);
    }
  }
}

TEST_CASE("the first iteration of every accelerated method is the plain one") {
  const TimeStep step = crumpled(with_stiffness_number(cloth(5, 6), 1e3), 3);
  const Points plain = after<LocalGlobal<SparseProblem>>(1, step);
  CHECK(after<Chebyshev<SparseProblem>>(1, step) == plain);
  CHECK(after<Anderson<SparseProblem>>(1, step) == plain);
  CHECK(after<Lbfgs<SparseProblem>>(1, step) == plain);
}

TEST_CASE("Chebyshev's acceleration sets in after its delay") {
  const TimeStep step = crumpled(with_stiffness_number(cloth(5, 6), 1e3), 3);
  const Chebyshev<SparseProblem> ten, three(3);
  CHECK(after(10, step, ten) == after<LocalGlobal<SparseProblem>>(10, step));
  CHECK(after(11, step, ten) != after<LocalGlobal<SparseProblem>>(11, step));
  CHECK(after(3, step, three) == after<LocalGlobal<SparseProblem>>(3, step));
  CHECK(after(4, step, three) != after<LocalGlobal<SparseProblem>>(4, step));
}

TEST_CASE("accelerated methods reach the objective of 50 plain iterations sooner") {
  const TimeStep step = with_stiffness_number(cloth(20, 40), 1e4);
  const double plain = objective(step, after<LocalGlobal<SparseProblem>>(50, step)).objective;
  // They take 4, 4 and 20, but how a descent goes on depends on every rounding.
  CHECK(iterations_to<Lbfgs<SparseProblem>>(plain, step) <= 6);
  CHECK(iterations_to<Anderson<SparseProblem>>(plain, step) <= 6);
  CHECK(iterations_to<Chebyshev<SparseProblem>>(plain, step) <= 25);
}

TEST_CASE_TEMPLATE("free fall takes a single iteration", Method, PLAIN_METHODS) {
  TimeStep step = crumpled(cloth(3, 4), 4);
  step.k = 1;
  step.E.resize(0, 2);
  step.r.resize(0);
  step.pinned.resize(0);
  step.targets.resize(0, 3);
  // Q⁻¹ ∂E/∂p is rounded in proportion to p, a few metres.
  CHECK((after<Method>(1, step) - inertial_prediction(step)).cwiseAbs().maxCoeff() < 1e-14);
  CHECK((after<Method>(3, step) - inertial_prediction(step)).cwiseAbs().maxCoeff() < 1e-14);
}

TEST_CASE_TEMPLATE("collapsed springs are pushed apart", Method, PLAIN_METHODS) {
  TimeStep step = with_stiffness_number(cloth(4, 5), 100);
  step.p_curr.setZero();
  step.p_prev.setZero();
  const Points p = after<Method>(20, step);
  CHECK(p.allFinite());
  CHECK(objective(step, p).objective < objective(step, step.p_curr).objective);
  CHECK((p.row(0) - p.row(1)).norm() > 0.5);
}

TEST_CASE_TEMPLATE("an iteration allocates nothing and solves once", Method, QUADRATIC_METHODS) {
  QuadraticProblem problem{Vector::LinSpaced(7, 0.1, 1)};
  Method method;
  Field p = Field::Zero(7, 4);
  p.leftCols(3).setRandom();
  method.begin(problem, p);
  Eigen::internal::set_is_malloc_allowed(false);
  int iterations = 0;
  while (iterations < 15 && method.iterate(problem, p)) ++iterations;
  Eigen::internal::set_is_malloc_allowed(true);
  CHECK(iterations == 15);
  CHECK(method.standing().solves == 15);
  CHECK(method.standing().gradient_evaluations >= 16);
  CHECK(p.col(3) == Vector::Zero(7));
}

TEST_CASE("Anderson's method solves a quadratic problem of few eigenvalues in as many iterations") {
  // It spans the same space as GMRES, which needs one iteration for each of the three, after a
  // plain one. What is left is rounding, magnified by the condition of the differences.
  const Vector h = Vector::Constant(9, 0.5) + Vector{{-4, -4, -4, 0, 0, 0, 4, 4, 4}} / 10;
  CHECK(distance_after<Anderson<QuadraticProblem>>(3, h) > 1e-6);
  CHECK(distance_after<Anderson<QuadraticProblem>>(4, h) < 1e-12);
}

TEST_CASE("on a quadratic objective acceleration beats the plain iteration's rate") {
  // The plain iteration shrinks the slowest part by 1 - h = 0.95 each time.
  const Vector h = Vector::LinSpaced(30, 0.05, 1);
  const double plain = distance_after<LocalGlobal<QuadraticProblem>>(60, h);
  CHECK(plain == doctest::Approx(std::pow(0.95, 60)).epsilon(1e-3));
  CHECK(distance_after<Chebyshev<QuadraticProblem>>(60, h) < 1e-1 * plain);
  CHECK(distance_after<Anderson<QuadraticProblem>>(60, h) < 1e-3 * plain);
  CHECK(distance_after<Lbfgs<QuadraticProblem>>(60, h) < 1e-3 * plain);
}

}  // namespace mass_spring
