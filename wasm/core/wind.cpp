#include "wind.h"

#include <cmath>

namespace mass_spring {

void wind(const Vector& m, double extent, double time, const Points& p, Points& f_ext) {
  for (int i = 0; i < m.size(); ++i) {
    // A scene of one point has no extent: the gusts are then the same everywhere.
    const double phase = (extent > 0 ? p(i, 0) / extent : 0) + time;
    const Eigen::RowVector3d acceleration(3 + 1.5 * (1 + std::cos(5 * phase)),
                                          std::cos(0.3 + phase), std::sin(phase));
    f_ext.row(i) += m(i) * acceleration;
  }
}

}  // namespace mass_spring
