#pragma once

#include <string>
#include <vector>

#include "status.h"

namespace mass_spring {

/// Are these different vertices of n?
/// @param field     what they are called: "pinned", "pulled"
/// @param vertices  #vertices
Status validate_vertices(const std::string& field, const std::vector<int>& vertices, int n);

}  // namespace mass_spring
