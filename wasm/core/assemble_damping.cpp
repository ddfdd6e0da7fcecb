#include "assemble_damping.h"

#include "dashpot_resistance.h"

namespace mass_spring {

Triplets assemble_damping(const TimeStep& step, const Points& q) {
  Triplets D;
  if (step.damping == 0) return D;
  D.reserve(36 * step.E.rows());
  for (int e = 0; e < step.E.rows(); ++e) {
    const int ends[2] = {step.E(e, 0), step.E(e, 1)};
    const Eigen::Matrix3d block = dashpot_resistance(q.row(ends[0]), q.row(ends[1]), step.damping);
    for (int row = 0; row < 6; ++row) {
      for (int column = 0; column < 6; ++column) {
        const double sign = row / 3 == column / 3 ? -1 : 1;
        D.emplace_back(3 * ends[row / 3] + row % 3, 3 * ends[column / 3] + column % 3,
                       sign * block(row % 3, column % 3));
      }
    }
  }
  return D;
}

}  // namespace mass_spring
