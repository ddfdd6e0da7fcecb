#pragma once

#include <vector>

#include "types.h"

namespace mass_spring {

/// @param rows  #points by 3, row-major
inline Points as_points(const std::vector<double>& rows) {
  return Eigen::Map<const Points>(rows.data(), rows.size() / 3, 3);
}

}  // namespace mass_spring
