#include "validate_points.h"

#include <cmath>

namespace mass_spring {

Status validate_points(const std::string& field, const std::vector<double>& points, int rows) {
  if (points.size() != 3 * static_cast<std::size_t>(rows)) {
    return {StatusCode::wrong_length, field, -1, static_cast<double>(points.size())};
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!std::isfinite(points[i]))
      return {StatusCode::not_finite, field, static_cast<int>(i / 3), points[i]};
  }
  return {};
}

}  // namespace mass_spring
