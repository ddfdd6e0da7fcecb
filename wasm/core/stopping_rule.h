#pragma once

#include <optional>
#include <string>
#include <vector>

#include "minimiser.h"

namespace mass_spring {

enum class StopReason { iterations, gradient, decrease, rounding };

/// The spelling of every StopReason, in order.
const std::vector<std::string>& stop_reason_names();

/// When to stop iterating: always after `iterations`, earlier where a threshold is above 0.
struct StoppingRule {
  int iterations;       // K
  double gradient = 0;  // N: stop once no component of ∂E/∂p of a free vertex is larger
  double decrease = 0;  // ε: stop once an iteration lowers E by no more than ε max(1 J, |E|)
};

/// What `decrease` is compared with: (E^{k-1} - E^k) / max(1 J, |E^k|), dimensionless.
/// @param objective_before  J: minimiser.objective() one iteration ago
double relative_decrease(double objective_before, const Minimiser& minimiser);

/// How a time step ended.
struct Outcome {
  StopReason reason;
  int iterations;  // made; for `rounding`, the last of them did not move p
};

/// Whether `minimiser` has done enough where it begins.
std::optional<Outcome> stop_at_start(const StoppingRule& rule, const Minimiser& minimiser);

/// One iteration, and whether it was the last.
std::optional<Outcome> iterate_once(const StoppingRule& rule, Minimiser& minimiser);

/// From p until the rule says stop or the method moves no further.
/// @param p  #V by 3, m
Outcome iterate_until(const StoppingRule& rule, Minimiser& minimiser, const Points& p);

}  // namespace mass_spring
