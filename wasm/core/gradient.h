#pragma once

#include "time_step.h"

namespace mass_spring {

/// ∂E/∂p: k Aᵀ(A p - d(p)) + M (p - 2p^t + p^{t-Δt})/Δt² - f^ext + w Cᵀ(C p - p^target), and of
/// dashpots and pulls where there are any. Without them it equals Q p - b for the d of a local step
/// at p, but is summed from small differences, where Q p - b cancels large numbers.
/// @param p  #V by 3, m
/// @param g  #V by 3, N (result)
void gradient(const TimeStep& step, const Points& p, Points& g);

}  // namespace mass_spring
