#pragma once

#include <string>
#include <vector>

namespace mass_spring {

/// What students of [J] get wrong most, one at a time; parts_with says what each changes.
enum class Mistake {
  none,
  d_once,
  k_forgotten,
  sign_in_A,
  times_swapped,
  rest_for_targets,
  pins_after_solving,
  factorised_again,
  gradient_as_force,
  stored_zeros,
  one_iteration,
};

/// The spelling of every Mistake, in order.
const std::vector<std::string>& mistake_names();

}  // namespace mass_spring
