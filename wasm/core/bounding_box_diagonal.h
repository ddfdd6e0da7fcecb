#pragma once

#include "types.h"

namespace mass_spring {

/// Length of the diagonal of the axis-aligned bounding box, m.
/// @param p  #V by 3, m, at least one row
double bounding_box_diagonal(const Points& p);

}  // namespace mass_spring
