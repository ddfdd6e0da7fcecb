#pragma once

namespace mass_spring {

/// Armijo's line search: tries the steps α = 1, ½, ¼, … until one lowers E by enough.
/// @param slope  J: derivative of E along the step, negative
/// @param falls  called with α and c α slope, J: does E change by less than that? If so, it moves
/// @return whether one did
template <typename Falls>
bool backtrack(double slope, Falls falls) {
  constexpr double c = 1e-4;
  constexpr double least_alpha = 1e-9;
  for (double alpha = 1; alpha > least_alpha; alpha /= 2) {
    if (falls(alpha, c * alpha * slope)) return true;
  }
  return false;
}

}  // namespace mass_spring
