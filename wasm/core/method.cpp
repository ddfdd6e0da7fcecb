#include "method.h"

namespace mass_spring {

const std::vector<std::string>& method_names() {
  static const std::vector<std::string> names = {
      "local-global", "chebyshev",         "anderson",         "lbfgs",
      "newton",       "linearly-implicit", "symplectic-euler", "forward-euler"};
  return names;
}

}  // namespace mass_spring
