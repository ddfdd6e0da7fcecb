#pragma once

#include "parameters.h"
#include "status.h"

namespace mass_spring {

/// Is every number finite, positive where it must be, and the number of iterations one that a trace
/// can hold?
Status validate_parameters(const Parameters& parameters);

}  // namespace mass_spring
