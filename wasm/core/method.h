#pragma once

#include <string>
#include <vector>

namespace mass_spring {

/// How p^{t+Δt} follows from p^t. The first five minimise E(p) iterate by iterate, local_global
/// being the paper's [L]; the others take the time step at once.
enum class Method {
  local_global,
  chebyshev,
  anderson,
  lbfgs,
  newton,
  linearly_implicit,
  symplectic_euler,
  forward_euler,
};

inline bool takes_one_step(Method method) { return method >= Method::linearly_implicit; }
inline bool is_explicit(Method method) { return method >= Method::symplectic_euler; }

/// The spelling of every Method, in order.
const std::vector<std::string>& method_names();

}  // namespace mass_spring
