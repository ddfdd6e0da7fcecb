#pragma once

#include <string>
#include <vector>

#include "types.h"

namespace mass_spring {

/// In which order to eliminate the unknowns of Q p = b: as they are numbered; by Eigen's
/// approximate minimum degree, where that numbering decides ties; or as the solver at hand does.
enum class Ordering { natural, minimum_degree, solver };

/// The spelling of every Ordering, in order.
const std::vector<std::string>& ordering_names();

/// @param Q        entries of the #V by #V matrix
/// @param solvers  vertices, the unknowns, in the order in which the solver eliminates them
/// @return the same vertices in the order asked for
std::vector<int> ordered_unknowns(Ordering ordering, const Triplets& Q, std::vector<int> solvers);

}  // namespace mass_spring
