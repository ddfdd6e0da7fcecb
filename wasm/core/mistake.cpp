#include "mistake.h"

namespace mass_spring {

const std::vector<std::string>& mistake_names() {
  static const std::vector<std::string> names = {
      "none",
      "d-once",
      "k-forgotten",
      "sign-in-A",
      "times-swapped",
      "rest-for-targets",
      "pins-after-solving",
      "factorised-again",
      "gradient-as-force",
      "stored-zeros",
      "one-iteration",
  };
  return names;
}

}  // namespace mass_spring
