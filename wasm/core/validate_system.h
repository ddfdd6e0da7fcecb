#pragma once

#include "parameters.h"
#include "status.h"
#include "time_step.h"

namespace mass_spring {

/// Can the system of this time step be solved to useful accuracy, and kept in memory?
Status validate_system(const TimeStep& step, Storage storage);

}  // namespace mass_spring
