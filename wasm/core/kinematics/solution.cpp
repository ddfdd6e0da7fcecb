#include "solution.h"

namespace kinematics {

const std::vector<std::string>& outcome_names() {
  static const std::vector<std::string> names = {"CONVERGED", "STALLED", "UNREACHABLE",
                                                 "MAX_ITERATIONS"};
  return names;
}

}  // namespace kinematics
