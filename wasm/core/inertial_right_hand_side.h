#pragma once

#include "time_step.h"

namespace mass_spring {

/// The part of b that no iteration changes: y = M (2p^t - p^{t-Δt})/Δt² + f^ext + w Cᵀ p^target.
/// [J] "Global step"
/// @param M  #V by #V, kg
/// @param C  #pinned by #V
/// @param y  #V by 3, N (result)
template <typename Matrix>
void inertial_right_hand_side(const TimeStep& step, const Matrix& M, const Matrix& C, Points& y);

}  // namespace mass_spring
