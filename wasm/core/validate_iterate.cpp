#include "validate_iterate.h"

#include <cmath>

namespace mass_spring {

Status validate_iterate(const Points& p) {
  for (int i = 0; i < p.rows(); ++i) {
    for (const double coordinate : p.row(i)) {
      if (!std::isfinite(coordinate)) return {StatusCode::diverged, "p", i, coordinate};
    }
  }
  return {};
}

}  // namespace mass_spring
