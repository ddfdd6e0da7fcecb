#pragma once

#include <vector>

#include "status.h"

namespace mass_spring {

/// Are these different vertices of n?
/// @param pinned  #pinned
Status validate_pinned(const std::vector<int>& pinned, int n);

}  // namespace mass_spring
