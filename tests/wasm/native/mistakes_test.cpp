#include <doctest/doctest.h>

#include "matrix_from_triplets.h"
#include "mistaken_simulation.h"
#include "right_parts.h"
#include "solver_parts.h"
#include "support.h"
#include "system_matrix.h"

namespace mass_spring {
namespace {

DenseMatrix dense(int rows, int columns, const Triplets& triplets) {
  DenseMatrix matrix;
  matrix_from_triplets(rows, columns, triplets, matrix);
  return matrix;
}

}  // namespace

TEST_CASE("from a right A, the parts' Q is system_matrix, bit for bit") {
  const TimeStep step = corner();
  const SolverParts parts = right_parts();
  const Triplets Q = parts.system(step, parts.incidence(step.E));
  CHECK(dense(3, 3, Q) ==
        dense(3, 3, system_matrix(step.E, step.k, step.m, step.delta_t, step.pinned, step.w)));
}

TEST_CASE("what each mistaken part computes, by hand") {
  const TimeStep step = corner();
  SparseMatrix M(3, 3), C(1, 3);
  M.insert(0, 0) = 1;
  M.insert(1, 1) = 2;
  M.insert(2, 2) = 4;
  C.insert(0, 2) = 1;
  const Points V = 2 * step.p_curr;  // elsewhere than the target
  Points y;

  SUBCASE("both entries of a row of A are +1, so that A·1 is 2") {
    const Triplets A = parts_with(Mistake::sign_in_A).incidence(step.E);
    CHECK(dense(2, 3, A) * Vector::Ones(3) == Vector{{2, 2}});
    const DenseMatrix Q = dense(3, 3, right_parts().system(step, A));
    CHECK(Q(0, 1) == 10);
  }
  SUBCASE("b lacks the factor k") {
    Workspace workspace;
    workspace.y.setConstant(3, 3, 7);
    SparseMatrix A;
    matrix_from_triplets(2, 3, right_parts().incidence(step.E), A);
    const Points d = Points::Ones(2, 3);
    parts_with(Mistake::k_forgotten).right_hand_side(A, step.k, d, workspace);
    // Springs (0, 1) and (2, 1) add +1 at 0 and 2, −1 − 1 at 1.
    CHECK(workspace.b.col(0) == Vector{{8, 5, 8}});
  }
  SUBCASE("with times swapped, inertia leads back") {
    TimeStep moving = step;
    moving.p_prev.col(0).array() -= 1;
    parts_with(Mistake::times_swapped).inertial(moving, V, M, C, y);
    // m (2 (x − 1) − x)/Δt² of vertex 1, at x = 3.
    CHECK(y(1, 0) == 2 * (2 * 2 - 3) / 0.25);
  }
  SUBCASE("w CᵀC V is the rest position of the pinned vertex, not its target") {
    parts_with(Mistake::rest_for_targets).inertial(step, V, M, C, y);
    CHECK(y(2, 1) == 4 * 4 / 0.25 + 100 * 8);
    parts_with(Mistake::none).inertial(step, V, M, C, y);
    CHECK(y(2, 1) == 4 * 4 / 0.25 + 100 * 4);
  }
  SUBCASE("the gradient of the external energy points against the force") {
    TimeStep heavy = step;
    heavy.p_curr.setZero();
    heavy.p_prev.setZero();
    heavy.f_ext.col(1).setConstant(-8);
    parts_with(Mistake::gradient_as_force).inertial(heavy, V, M, C, y);
    CHECK(y(0, 1) == 8);
  }
  SUBCASE("pins imposed after solving are neither in Q nor in y") {
    const SolverParts parts = parts_with(Mistake::pins_after_solving);
    CHECK(dense(3, 3, parts.system(step, parts.incidence(step.E)))(2, 2) == 10 + 4 / 0.25);
    parts.inertial(step, V, M, C, y);
    CHECK(y(2, 1) == 4 * 4 / 0.25);
  }
}

TEST_CASE("every mistake runs, moves pins and changes parameters within its memory") {
  const int count = static_cast<int>(mistake_names().size());
  for (int mistake = 0; mistake < count; ++mistake) {
    MistakenSimulation simulation;
    Parameters parameters = usual_parameters();
    REQUIRE(simulation
                .set_scene({0, 0, 0, 1, 0, 0, 2, 0, 0}, {0, 1, 1, 2}, {1, 1, 1}, {0}, parameters,
                           static_cast<Mistake>(mistake))
                .ok());
    for (int step = 0; step < 3; ++step) REQUIRE(simulation.step().ok());
    parameters.k *= 2;
    parameters.iterations = 3;
    REQUIRE(simulation.set_parameters(parameters).ok());
    REQUIRE(simulation.set_pins({2, 0}, {2, 1, 0, 0, 0, 0}).ok());
    for (int step = 0; step < 3; ++step) REQUIRE(simulation.step().ok());
    CHECK(simulation.step_number() == 6);
    CHECK(simulation.p().allFinite());
  }
}

}  // namespace mass_spring
