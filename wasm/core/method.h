#pragma once

#include <string>
#include <vector>

namespace mass_spring {

/// How p gets from one iterate to the next. [L] is the paper's; the others minimise the same E(p).
enum class Method { local_global, chebyshev, anderson, lbfgs, newton };

/// The spelling of every Method, in order.
const std::vector<std::string>& method_names();

}  // namespace mass_spring
