#include "linearly_implicit_euler.h"

#include <limits>

#include "assemble_forces.h"
#include "d2V_spring_particle_particle_dq2.h"
#include "dashpot_resistance.h"
#include "velocity_at_start.h"

namespace mass_spring {

void LinearlyImplicitEuler::operator()(const TimeStep& step, Points& q) {
  const int n = static_cast<int>(step.m.size());
  if (!blocks_.fits(step.E, n, step.pinned)) {
    blocks_.analyse(step.E, n, step.pinned);
    ldlt_.analyzePattern(blocks_.matrix());
  }

  Points q_dot = Points::Zero(n, 3);  // #V by 3, m/s: of the pinned vertices, as they are moved
  for (int c = 0; c < step.pinned.size(); ++c) {
    const int i = step.pinned(c);
    q_dot.row(i) = (step.targets.row(c) - step.p_curr.row(i)) / step.delta_t;
  }
  fill_in(step, q_dot);

  Vector x(b_.size());
  ldlt_.factorize(blocks_.matrix());
  if (ldlt_.info() == Eigen::Success) {
    x = ldlt_.solve(b_);
  } else {
    x.setConstant(std::numeric_limits<double>::quiet_NaN());
  }
  blocks_.scatter(x, q_dot);
  q = step.p_curr + step.delta_t * q_dot;
  for (int c = 0; c < step.pinned.size(); ++c) q.row(step.pinned(c)) = step.targets.row(c);
}

/// Matrix and right-hand side, P(M q̇^t + Δt f) less what the matrix makes of the pinned vertices.
/// @param q_dot  #V by 3, m/s: of the pinned vertices, 0 elsewhere
void LinearlyImplicitEuler::fill_in(const TimeStep& step, const Points& q_dot) {
  const int n = static_cast<int>(step.m.size());
  const double delta_t = step.delta_t;
  Points f;  // #V by 3, N; the dashpots resist the new velocities, by the matrix
  assemble_forces(step, step.p_curr, Points::Zero(n, 3), f);
  Points b = step.m.asDiagonal() * velocity_at_start(step) + delta_t * f;  // #V by 3, N s

  blocks_.set_zero();
  for (int e = 0; e < step.E.rows(); ++e) {
    const int i = step.E(e, 0), j = step.E(e, 1);
    const auto d2V =
        d2V_spring_particle_particle_dq2(step.p_curr.row(i), step.p_curr.row(j), step.r(e), step.k);
    Eigen::Matrix3d block = delta_t * delta_t * d2V.topLeftCorner<3, 3>();  // kg
    if (step.damping > 0) {
      block += delta_t * dashpot_resistance(step.p_curr.row(i), step.p_curr.row(j), step.damping);
    }
    blocks_.add_spring(e, block);
    b.row(i) += q_dot.row(j) * block;
    b.row(j) += q_dot.row(i) * block;
  }
  for (int i = 0; i < n; ++i) blocks_.add_vertex(i, step.m(i));
  for (const int i : step.pull.vertices) {
    blocks_.add_vertex(i, delta_t * delta_t * step.pull.k);
  }

  blocks_.gather(b, b_);
}

}  // namespace mass_spring
