#include <doctest/doctest.h>

#include <Eigen/Eigenvalues>
#include <cmath>

#include "T_particle.h"
#include "V_gravity_particle.h"
#include "V_spring_particle_particle.h"
#include "assemble_forces.h"
#include "assemble_stiffness.h"
#include "d2V_spring_particle_particle_dq2.h"
#include "dV_gravity_particle_dq.h"
#include "dV_spring_particle_particle_dq.h"
#include "damping_energy.h"
#include "fastest_oscillation.h"
#include "fixed_point_constraints.h"
#include "forward_euler.h"
#include "gradient.h"
#include "hessian.h"
#include "linearly_implicit_euler.h"
#include "linearly_implicit_terms.h"
#include "mass_matrix_particles.h"
#include "matrix_from_triplets.h"
#include "mechanical_energy.h"
#include "objective.h"
#include "objective_change.h"
#include "random_scene.h"
#include "stability_limit.h"
#include "symplectic_euler.h"
#include "velocity_at_start.h"

namespace mass_spring {
namespace {

SparseMatrix matrix(int rows, int columns, const Triplets& triplets) {
  SparseMatrix A;
  matrix_from_triplets(rows, columns, triplets, A);
  return A;
}

/// Pinned vertices and all.
SparseMatrix hessian_of(const TimeStep& step, const Points& p) {
  SpringBlocks H;
  H.analyse(step.E, static_cast<int>(p.rows()), {});
  hessian(step, p, 0, H);
  return H.matrix();
}

/// A scene in motion with dashpots, two of whose vertices are pulled.
TestScene damped_and_pulled() {
  TestScene scene = random_scene(20, 60, 3, 5);
  scene.step.damping = 0.4;
  scene.step.pull.vertices = Indices{{7, 4}};
  scene.step.pull.targets = random_points(2, 9);
  scene.step.pull.k = 3;
  return scene;
}

template <typename Integrator>
Points step_by(Integrator integrator, const TimeStep& step) {
  Points p;
  integrator(step, p);
  return p;
}

/// Two masses of m on a spring of k, 1 m long and stretched by x, along the x axis, at rest.
TimeStep pair_of_masses(double x, double m, double k, double delta_t) {
  TimeStep step;
  step.E.resize(1, 2);
  step.E << 0, 1;
  step.r = Vector::Ones(1);
  step.m = Vector::Constant(2, m);
  step.k = k;
  step.delta_t = delta_t;
  step.p_curr.resize(2, 3);
  step.p_curr << 0, 0, 0, 1 + x, 0, 0;
  step.p_prev = step.p_curr;
  step.f_ext.setZero(2, 3);
  return step;
}

double stretch(const Points& p) { return p(1, 0) - p(0, 0) - 1; }

}  // namespace

TEST_CASE("energies of particles, by hand") {
  CHECK(T_particle({1, 2, 2}, 4) == 18);
  CHECK(V_gravity_particle({1, 3, 5}, 2, {0, -10, 0}) == 60);
  CHECK(dV_gravity_particle_dq(2, {0, -10, 0}) == Eigen::Vector3d(0, 20, 0));
  CHECK(V_spring_particle_particle({0, 3, 0}, {4, 0, 0}, 3, 10) == 20);
}

TEST_CASE("gradient and Hessian of a spring are its finite differences") {
  const Points points = random_points(40, 3);
  const double h = 1e-5, k = 7, l0 = 0.8;  // m, N/m, m
  for (int pair = 0; pair < 20; ++pair) {
    Eigen::Matrix<double, 6, 1> q;
    q << points.row(2 * pair).transpose(), points.row(2 * pair + 1).transpose();
    const auto V = [&](const Eigen::Matrix<double, 6, 1>& at) {
      return V_spring_particle_particle(at.head<3>(), at.tail<3>(), l0, k);
    };
    const auto dV = [&](const Eigen::Matrix<double, 6, 1>& at) {
      return dV_spring_particle_particle_dq(at.head<3>(), at.tail<3>(), l0, k);
    };
    const auto d2V = d2V_spring_particle_particle_dq2(q.head<3>(), q.tail<3>(), l0, k);
    const double l = (q.head<3>() - q.tail<3>()).norm();
    for (int c = 0; c < 6; ++c) {
      const Eigen::Matrix<double, 6, 1> step = h * Eigen::Matrix<double, 6, 1>::Unit(c);
      // Central differences err by h²/6 times the third derivative, some k/l² here, and by
      // rounding.
      const double tolerance = 10 * k * h * h / std::min(1.0, l * l * l) + 1e-9;
      CHECK(std::abs((V(q + step) - V(q - step)) / (2 * h) - dV(q)(c)) < tolerance);
      CHECK(((dV(q + step) - dV(q - step)) / (2 * h) - d2V.col(c)).cwiseAbs().maxCoeff() <
            tolerance);
    }
  }
}

TEST_CASE("a collapsed spring pushes along x and its Hessian is finite") {
  const Eigen::Vector3d q(1, 2, 3);
  CHECK(dV_spring_particle_particle_dq(q, q, 2, 10).head<3>() == Eigen::Vector3d(-20, 0, 0));
  CHECK(dV_spring_particle_particle_dq(q, q, 0, 10).norm() == 0);
  CHECK(d2V_spring_particle_particle_dq2(q, q, 2, 10)(0, 0) == 10);
  CHECK(d2V_spring_particle_particle_dq2(q, q, 2, 10).allFinite());
}

TEST_CASE("dashpots and pulls: E's gradient and Hessian are its finite differences") {
  const TestScene scene = damped_and_pulled();
  TimeStep step = scene.step;
  step.w = 50;  // the other terms would drown in the stiff penalty's rounding
  const Points p = step.p_curr + 0.02 * random_points(20, 11);
  Points g, before, after;
  gradient(step, p, g);
  const SparseMatrix H = hessian_of(step, p);
  const double h = 1e-6;  // m
  for (int i = 0; i < 20; ++i) {
    for (int c = 0; c < 3; ++c) {
      Points left = p, right = p;
      left(i, c) -= h;
      right(i, c) += h;
      const double slope = objective_change(step, left, right) / (2 * h);
      gradient(step, left, before);
      gradient(step, right, after);
      const Points curvature = (after - before) / (2 * h);
      const Points column = Eigen::Map<const Points>(DenseMatrix(H.col(3 * i + c)).data(), 20, 3);
      // Rounding of forces of some N over h, and h² times third derivatives.
      CHECK(std::abs(slope - g(i, c)) < 1e-7 * (1 + std::abs(g(i, c))));
      CHECK((curvature - column).cwiseAbs().maxCoeff() < 1e-5 * H.norm());
    }
  }
  CHECK(objective_change(step, step.p_curr, p) ==
        doctest::Approx(objective(step, p).objective - objective(step, step.p_curr).objective));
}

TEST_CASE("forces are what E's gradient is without inertia; dashpots resist with the velocity") {
  TimeStep step = damped_and_pulled().step;
  step.w = 0;
  const Points velocity = random_points(20, 13);
  Points f, g;
  assemble_forces(step, step.p_curr, velocity, f);
  step.p_prev = step.p_curr;
  gradient(step, step.p_curr, g);
  Points dashpots = Points::Zero(20, 3);  // N
  add_damping_gradient(step, step.p_curr + step.delta_t * velocity, dashpots);
  CHECK((f + g + dashpots).cwiseAbs().maxCoeff() < 1e-13 * f.cwiseAbs().maxCoeff());
}

TEST_CASE("K is symmetric and minus E's Hessian without inertia; P selects what is free") {
  TimeStep step = damped_and_pulled().step;
  const SparseMatrix K = matrix(60, 60, assemble_stiffness(step, step.p_curr));
  CHECK(SparseMatrix(K - SparseMatrix(K.transpose())).norm() == 0);

  const SparseMatrix M = matrix(60, 60, mass_matrix_particles(step.m));
  step.damping = step.w = 0;
  const SparseMatrix H = hessian_of(step, step.p_curr);
  const SparseMatrix inertia = M / (step.delta_t * step.delta_t);
  CHECK(SparseMatrix(K + H - inertia).norm() < 1e-14 * H.norm());

  const Triplets selected = fixed_point_constraints(20, step.pinned);
  const SparseMatrix P = matrix(51, 60, selected);
  CHECK(DenseMatrix(P * P.transpose()) == DenseMatrix::Identity(51, 51));
  const SparseMatrix PKPt = P * K * P.transpose();
  CHECK(SparseMatrix(PKPt - SparseMatrix(PKPt.transpose())).norm() == 0);
  // Vertices 0, 1 and 2 are pinned: row 0 is x of vertex 3.
  CHECK(P.coeff(0, 9) == 1);
}

TEST_CASE("linearly implicit Euler solves its equation, pins dragged along, pattern reused") {
  TestScene scene = damped_and_pulled();
  LinearlyImplicitEuler integrator;
  for (int t = 0; t < 3; ++t) {
    TimeStep& step = scene.step;
    const Points q = step_by([&](const TimeStep& s, Points& p) { integrator(s, p); }, step);
    CHECK(q(step.pinned, Eigen::all) == step.targets);
    const Points velocity = (q - step.p_curr) / step.delta_t;

    // M (v' - v)/Δt = f + Δt K v' and the dashpots' force at v', for the free vertices.
    Points f, dashpots = Points::Zero(20, 3);
    assemble_forces(step, step.p_curr, velocity, f);
    const SparseMatrix K = matrix(60, 60, assemble_stiffness(step, step.p_curr));
    Points Kv(20, 3);
    Kv.reshaped<Eigen::RowMajor>() = K * Vector(velocity.reshaped<Eigen::RowMajor>());
    const Points impulse = step.m.asDiagonal() * (velocity - velocity_at_start(step));
    Points missed = impulse / step.delta_t - f - step.delta_t * Kv;
    missed(step.pinned, Eigen::all).setZero();
    const double size = std::max(f.cwiseAbs().maxCoeff(), Kv.cwiseAbs().maxCoeff());
    CHECK(missed.cwiseAbs().maxCoeff() < 1e-10 * (1 + size));

    step.p_prev = step.p_curr;
    step.p_curr = q;
    if (t == 1) {  // another set of pins, the last one freed
      step.pinned.conservativeResize(2);
      step.targets.conservativeResize(2, 3);
    }
  }
}

TEST_CASE("its matrix is P (M - Δt D - Δt² K) Pᵀ") {
  TimeStep step = damped_and_pulled().step;
  LinearlyImplicitEuler integrator;
  Points q;
  integrator(step, q);
  step.w = 0;
  // H = (M - Δt D)/Δt² - K at p = p^t.
  const SparseMatrix H = hessian_of(step, step.p_curr);
  const SparseMatrix P = matrix(51, 60, fixed_point_constraints(20, step.pinned));
  const SparseMatrix by_hessian = step.delta_t * step.delta_t * (P * H * P.transpose());
  CHECK(SparseMatrix(integrator.matrix() - by_hessian).norm() < 1e-14 * by_hessian.norm());
  const SparseMatrix by_terms = linearly_implicit_terms(step, step.p_curr).constrained;
  CHECK(SparseMatrix(integrator.matrix() - by_terms).norm() < 1e-14 * by_terms.norm());
}

TEST_CASE("at rest everything stays at rest") {
  TimeStep step = flag(5, 4, 10).step;
  step.p_prev = step.p_curr = flag(5, 4, 10).V;
  step.targets = step.p_curr(step.pinned, Eigen::all);
  step.f_ext.setZero();
  step.damping = 0.1;
  // Lengths are the rest lengths' very numbers: no force, not even rounding.
  CHECK(step_by(ForwardEuler(), step) == step.p_curr);
  CHECK(step_by(SymplecticEuler(), step) == step.p_curr);
  CHECK(step_by(LinearlyImplicitEuler(), step) == step.p_curr);
  CHECK(forward_euler_previous(step) == step.p_curr);
}

TEST_CASE("nothing fixed, nothing external: the momentum is kept") {
  TestScene scene = random_scene(20, 60, 0, 21);
  TimeStep& step = scene.step;
  step.f_ext.setZero();
  step.damping = 0.02;
  const auto momentum = [&](const Points& p, const Points& before) {
    return Eigen::RowVector3d(step.m.transpose() * (p - before) / step.delta_t);
  };
  const Eigen::RowVector3d at_start = momentum(step.p_curr, step.p_prev);
  // Sums of 20 products of some 0.02 kg and 1 m/s, solved for with a condition of some 100.
  const double tolerance = 1e-12;
  CHECK((momentum(step_by(SymplecticEuler(), step), step.p_curr) - at_start).norm() < tolerance);
  CHECK((momentum(step_by(LinearlyImplicitEuler(), step), step.p_curr) - at_start).norm() <
        tolerance);
  CHECK((momentum(step_by(ForwardEuler(), step), forward_euler_previous(step)) - at_start).norm() <
        tolerance);
}

TEST_CASE("two masses on a line follow the recurrence of implicit Euler") {
  // Of the stretch x: v' = (v - Δt ω² x)/(1 + Δt² ω²), x' = x + Δt v', ω² = 2k/m. On a line the
  // spring is linear, and one linear step is exact.
  const double m = 0.5, k = 80, delta_t = 0.01;
  TimeStep step = pair_of_masses(0.2, m, k, delta_t);
  double x = 0.2, v = 0;
  const double squared = 2 * k / m;
  LinearlyImplicitEuler integrator;
  for (int t = 0; t < 200; ++t) {
    Points next;
    integrator(step, next);
    step.p_prev = step.p_curr;
    step.p_curr = next;
    v = (v - delta_t * squared * x) / (1 + delta_t * delta_t * squared);
    x += delta_t * v;
    CHECK(std::abs(stretch(next) - x) < 1e-11);
  }
}

TEST_CASE("forward and symplectic Euler follow their recurrences, damped") {
  const double m = 0.5, k = 80, delta_t = 0.004, c = 0.3;
  const double squared = 2 * k / m, resistance = 2 * c / m;  // ω² and the damping of the stretch
  for (const bool forward : {true, false}) {
    TimeStep step = pair_of_masses(0.2, m, k, delta_t);
    step.damping = c;
    double x = 0.2, v = 0;
    for (int t = 0; t < 100; ++t) {
      const Points next =
          forward ? step_by(ForwardEuler(), step) : step_by(SymplecticEuler(), step);
      step.p_prev = forward ? forward_euler_previous(step) : step.p_curr;
      step.p_curr = next;
      const double a = -squared * x - resistance * v;
      if (forward) x += delta_t * v;
      v += delta_t * a;
      if (!forward) x += delta_t * v;
      CHECK(std::abs(stretch(next) - x) < 1e-12);
      CHECK(std::abs((velocity_at_start(step)(1, 0) - velocity_at_start(step)(0, 0)) - v) < 1e-9);
    }
  }
}

TEST_CASE("the largest frequency: two masses, a chain, a pull, and what is pinned") {
  CHECK(fastest_oscillation(pair_of_masses(0, 0.5, 80, 1), pair_of_masses(0, 0.5, 80, 1).p_curr)
            .omega == doctest::Approx(std::sqrt(2 * 80 / 0.5)));
  TimeStep step = pair_of_masses(0, 0.5, 80, 1);
  step.pinned = Indices{{0}};
  CHECK(fastest_oscillation(step, step.p_curr).omega == doctest::Approx(std::sqrt(80 / 0.5)));
  step.pull.vertices = Indices{{1}};
  step.pull.targets = Points::Zero(1, 3);
  step.pull.k = 40;
  CHECK(fastest_oscillation(step, step.p_curr).omega == doctest::Approx(std::sqrt(120 / 0.5)));
  step.pinned = Indices{{0, 1}};
  CHECK(fastest_oscillation(step, step.p_curr).omega == 0);
  CHECK(fastest_oscillation(step, step.p_curr).zeta == 0);
  // Against all eigenvalues of M^-½ (-K) M^-½ of a net at rest, where nothing pushes.
  TestScene net = flag(6, 5, 10);
  net.step.pinned.resize(0);
  const Vector scale = matrix(90, 90, mass_matrix_particles(net.step.m)).diagonal().cwiseSqrt();
  const DenseMatrix K = matrix(90, 90, assemble_stiffness(net.step, net.V));
  const DenseMatrix scaled = scale.asDiagonal().inverse() * -K * scale.asDiagonal().inverse();
  const double exact =
      std::sqrt(Eigen::SelfAdjointEigenSolver<DenseMatrix>(scaled).eigenvalues().maxCoeff());
  CHECK(fastest_oscillation(net.step, net.V).omega == doctest::Approx(exact).epsilon(5e-3));
}

TEST_CASE(
    "the damping ratio of the fastest oscillation is that of its dashpots, and a pull has none") {
  TimeStep step = pair_of_masses(0, 0.5, 80, 1);
  step.damping = 3;
  // Two halves of a kilogram: the stretch is slowed by 2c/m of its velocity, 2ζω, with ω² = 2k/m.
  CHECK(fastest_oscillation(step, step.p_curr).zeta ==
        doctest::Approx(2 * 3 / 0.5 / (2 * std::sqrt(2 * 80 / 0.5))));
  // Pulled so much harder than by its spring, vertex 1 oscillates by itself, in any direction: its
  // dashpot slows it by no more than c/m.
  step.pull.vertices = Indices{{1}};
  step.pull.targets = step.p_curr.row(1);
  step.pull.k = 1e12;
  const Oscillation pulled = fastest_oscillation(step, step.p_curr);
  CHECK(pulled.omega == doctest::Approx(std::sqrt(1e12 / 0.5)));
  CHECK(pulled.zeta <= 1.001 * 3 / 0.5 / (2 * pulled.omega));
}

TEST_CASE("explicit methods hold an oscillation up to their limits, and not beyond") {
  for (const Method method : {Method::symplectic_euler, Method::forward_euler}) {
    for (const double zeta : {0.0, 0.3, 1.5}) {
      const double limit = stability_limit(method, zeta);
      for (const double share : {0.98, 1.02}) {
        // ω = √2 of masses of 1 kg on 1 N/m; ζ = c ω/(2k).
        const double omega = std::sqrt(2.0), delta_t = (limit == 0 ? 0.2 : share * limit) / omega;
        TimeStep step = pair_of_masses(0.001, 1, 1, delta_t);
        step.damping = 2 * zeta / omega;
        for (int t = 0; t < 4000; ++t) {
          const bool forward = method == Method::forward_euler;
          const Points next =
              forward ? step_by(ForwardEuler(), step) : step_by(SymplecticEuler(), step);
          step.p_prev = forward ? forward_euler_previous(step) : step.p_curr;
          step.p_curr = next;
          if (std::abs(stretch(next)) > 0.5) break;
        }
        // A millimetre that grows by some percent of itself each step reaches half a metre.
        const bool grew = std::abs(stretch(step.p_curr)) > 0.5;
        CHECK(grew == (limit == 0 || share > 1));
      }
    }
  }
  CHECK(stability_limit(Method::symplectic_euler, 0) == 2);
  CHECK(stability_limit(Method::forward_euler, 0) == 0);
  CHECK(std::isinf(stability_limit(Method::newton, 0)));
}

}  // namespace mass_spring
