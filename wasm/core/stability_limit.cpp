#include "stability_limit.h"

#include <cmath>
#include <limits>

namespace mass_spring {

double stability_limit(Method method, double zeta) {
  switch (method) {
    case Method::symplectic_euler:
      return 2 * (std::sqrt(1 + zeta * zeta) - zeta);
    case Method::forward_euler:
      return zeta < 1 ? 2 * zeta : 2 * (zeta - std::sqrt(zeta * zeta - 1));
    default:
      return std::numeric_limits<double>::infinity();
  }
}

}  // namespace mass_spring
