#pragma once

#include <vector>

#include "status.h"

namespace mass_spring {

/// Does every spring join two different vertices of n, and no two springs the same two?
/// @param E  #E by 2, row-major
Status validate_springs(const std::vector<int>& E, int n);

}  // namespace mass_spring
