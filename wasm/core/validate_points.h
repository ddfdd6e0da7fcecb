#pragma once

#include <string>
#include <vector>

#include "status.h"

namespace mass_spring {

/// Are these `rows` points of three finite coordinates each?
/// @param field   the name of the array, for the status
/// @param points  row-major
Status validate_points(const std::string& field, const std::vector<double>& points, int rows);

}  // namespace mass_spring
