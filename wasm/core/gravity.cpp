#include "gravity.h"

namespace mass_spring {

void gravity(const Vector& m, double acceleration, Points& f_ext) {
  f_ext.setZero(m.size(), 3);
  f_ext.col(1) = -acceleration * m;
}

}  // namespace mass_spring
