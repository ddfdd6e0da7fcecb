#pragma once

#include "types.h"

namespace mass_spring {

/// Whether two lists without repetitions name the same vertices, in whatever order.
bool same_set(Indices a, Indices b);

}  // namespace mass_spring
