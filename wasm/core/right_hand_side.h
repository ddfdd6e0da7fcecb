#pragma once

#include "time_step.h"

namespace mass_spring {

/// b = k Aᵀd + y. [J] "Global step"
/// @param A  #E by #V
/// @param k  N/m
/// @param d  #E by 3, m
/// @param workspace  reads y; leaves b
template <typename Matrix>
void right_hand_side(const Matrix& A, double k, const Points& d, Workspace& workspace);

}  // namespace mass_spring
