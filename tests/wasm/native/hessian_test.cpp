#include "hessian.h"

#include <Eigen/Eigenvalues>

#include "gradient.h"
#include "methods_support.h"
#include "support.h"

namespace mass_spring {
namespace {

DenseMatrix dense_hessian(const TimeStep& step, const Points& p, double left_out) {
  SpringBlocks H;
  H.analyse(step.E, static_cast<int>(p.rows()), {});
  hessian(step, p, left_out, H);
  return DenseMatrix(H.matrix());
}

double least_eigenvalue(const DenseMatrix& H) {
  return Eigen::SelfAdjointEigenSolver<DenseMatrix>(H, Eigen::EigenvaluesOnly).eigenvalues()(0);
}

/// A cloth squeezed to half its size in every direction, so that all springs push: κ = 1000.
TimeStep squeezed() {
  TimeStep step = with_stiffness_number(cloth(3, 4), 1000);
  step.w = 1e3;
  step.p_curr *= 0.5;
  return step;
}

}  // namespace

TEST_CASE("the Hessian of a single spring, by hand") {
  TimeStep step = corner();
  step.E.conservativeResize(1, 2);
  step.r.conservativeResize(1);
  Points p = step.p_curr;
  p(1, 0) = 6;  // from r = 3 to l = 6 along x: k along it, k (1 - 3/6) across
  const DenseMatrix H = dense_hessian(step, p, 0);
  CHECK(H.row(0).head(6) == Eigen::RowVectorXd{{10 + 4, 0, 0, -10, 0, 0}});
  CHECK(H.row(4).head(6) == Eigen::RowVectorXd{{0, -5, 0, 0, 5 + 8, 0}});
  CHECK(H.row(8).tail(3) == Eigen::RowVector3d(0, 0, 16 + 100));
}

TEST_CASE("the Hessian is the derivative of the gradient") {
  const TimeStep step = crumpled(with_stiffness_number(cloth(3, 4), 1000), 1);
  const Points& p = step.p_curr;
  const DenseMatrix H = dense_hessian(step, p, 0);
  CHECK(H == H.transpose());
  // Central differences are off by h² ∂⁴E/6 ≈ h² k/l², and by the rounding of w |p| 1e-16 / h at a
  // pin: 1e-6 N/m and 1e-1 N/m of the w = 1e10 there.
  const double h = 1e-5;  // m
  for (int x = 0; x < p.size(); ++x) {
    Points before = p, after = p, g_before, g_after;
    before.reshaped<Eigen::RowMajor>()(x) -= h;
    after.reshaped<Eigen::RowMajor>()(x) += h;
    gradient(step, before, g_before);
    gradient(step, after, g_after);
    const Vector difference = ((g_after - g_before) / (2 * h)).reshaped<Eigen::RowMajor>();
    CHECK((difference - H.col(x)).norm() < 1e-10 * H.col(x).norm() + 1e-5 * step.k);
  }
}

TEST_CASE("without the negative curvature of springs that push, the Hessian is positive definite") {
  const TimeStep step = squeezed();
  CHECK(least_eigenvalue(dense_hessian(step, step.p_curr, 0)) < 0);
  // Nothing lies below M/Δt², up to the rounding of the largest entries, k ≈ 1e5.
  const double inertia = 1 / (step.delta_t * step.delta_t);
  CHECK(least_eigenvalue(dense_hessian(step, step.p_curr, 1)) > inertia - 1e-8);
}

TEST_CASE("the share left out leads linearly from the exact Hessian to the positive definite one") {
  const TimeStep step = squeezed();
  const DenseMatrix exact = dense_hessian(step, step.p_curr, 0);
  const DenseMatrix definite = dense_hessian(step, step.p_curr, 1);
  // Entries are sums of a few products.
  CHECK(dense_hessian(step, step.p_curr, 0.25).isApprox(0.75 * exact + 0.25 * definite, 1e-14));
}

TEST_CASE("a collapsed spring has no direction to be finite in, but a definite Hessian") {
  const TimeStep step = corner();
  Points p = step.p_curr;
  p.row(0) = p.row(1);
  CHECK_FALSE(dense_hessian(step, p, 0).allFinite());
  CHECK(least_eigenvalue(dense_hessian(step, p, 1)) > 3.9);  // M/Δt² of vertex 0 is 4 N/m
}

TEST_CASE("a spring of rest length zero is stiff alike in all directions, collapsed or not") {
  TimeStep step = corner();
  step.r.setZero();
  Points p = step.p_curr;
  const DenseMatrix apart = dense_hessian(step, p, 0);
  p.row(0) = p.row(1);
  CHECK(dense_hessian(step, p, 0) == apart);
}

}  // namespace mass_spring
