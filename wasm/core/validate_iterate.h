#pragma once

#include "status.h"
#include "types.h"

namespace mass_spring {

/// `diverged`, and where, if a coordinate is infinite or not a number.
/// @param p  #V by 3, m
Status validate_iterate(const Points& p);

}  // namespace mass_spring
