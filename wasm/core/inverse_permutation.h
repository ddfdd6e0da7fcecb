#pragma once

#include <vector>

namespace mass_spring {

/// @param order  which element comes first, second, …
/// @return  for every element, the place where it comes
std::vector<int> inverse_permutation(const std::vector<int>& order);

}  // namespace mass_spring
