#include "validate_masses.h"

#include <cmath>

namespace mass_spring {

Status validate_masses(const std::vector<double>& m, int n) {
  if (m.size() != static_cast<std::size_t>(n)) {
    return {StatusCode::wrong_length, "m", -1, static_cast<double>(m.size())};
  }
  for (int i = 0; i < n; ++i) {
    if (!std::isfinite(m[i])) return {StatusCode::not_finite, "m", i, m[i]};
    if (m[i] <= 0) return {StatusCode::not_positive, "m", i, m[i]};
  }
  return {};
}

}  // namespace mass_spring
