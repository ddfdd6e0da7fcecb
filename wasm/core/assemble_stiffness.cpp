#include "assemble_stiffness.h"

#include "d2V_spring_particle_particle_dq2.h"

namespace mass_spring {

Triplets assemble_stiffness(const TimeStep& step, const Points& q) {
  Triplets K;
  K.reserve(36 * step.E.rows() + 3 * step.pull.vertices.size());
  for (int e = 0; e < step.E.rows(); ++e) {
    const int ends[2] = {step.E(e, 0), step.E(e, 1)};
    const auto d2V =
        d2V_spring_particle_particle_dq2(q.row(ends[0]), q.row(ends[1]), step.r(e), step.k);
    for (int row = 0; row < 6; ++row) {
      for (int column = 0; column < 6; ++column) {
        K.emplace_back(3 * ends[row / 3] + row % 3, 3 * ends[column / 3] + column % 3,
                       -d2V(row, column));
      }
    }
  }
  for (const int i : step.pull.vertices) {
    for (int c = 0; c < 3; ++c) K.emplace_back(3 * i + c, 3 * i + c, -step.pull.k);
  }
  return K;
}

}  // namespace mass_spring
