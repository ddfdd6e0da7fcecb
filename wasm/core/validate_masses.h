#pragma once

#include <vector>

#include "status.h"

namespace mass_spring {

/// Are these n masses, each finite and positive?
/// @param m  #V, kg
Status validate_masses(const std::vector<double>& m, int n);

}  // namespace mass_spring
