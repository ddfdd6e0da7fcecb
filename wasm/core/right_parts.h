#pragma once

#include "solver_parts.h"

namespace mass_spring {

/// The solver as it should be, of the functions that the plain path is made of.
SolverParts right_parts();

}  // namespace mass_spring
