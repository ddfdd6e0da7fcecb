#pragma once

#include "time_step.h"

namespace mass_spring {

/// E(q) - E(p), J, summed from small differences: for q near p it keeps the digits that subtracting
/// two objectives would cancel.
/// @param p  #V by 3, m
/// @param q  #V by 3, m
double objective_change(const TimeStep& step, const Points& p, const Points& q);

}  // namespace mass_spring
