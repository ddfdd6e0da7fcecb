#pragma once

#include <vector>

#include "graph.h"
#include "types.h"

namespace mass_spring {

/// Cut the mesh in two where few vertices keep the halves apart, eliminate both halves, each by the
/// same rule, and these separating vertices last: no fill crosses them. [George 1973, "Nested
/// dissection of a regular finite element mesh"]
/// @param V      #vertices by 3, m: places by which halves are told
/// @param graph  of these vertices
/// @return which vertex comes first, second, …
std::vector<int> nested_dissection(const Points& V, const Graph& graph);

}  // namespace mass_spring
