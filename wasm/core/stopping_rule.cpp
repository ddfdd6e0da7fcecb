#include "stopping_rule.h"

#include <algorithm>
#include <cmath>

namespace mass_spring {

const std::vector<std::string>& stop_reason_names() {
  static const std::vector<std::string> names = {"iterations", "gradient", "decrease", "rounding"};
  return names;
}

// ‖∂E/∂p‖∞ ≤ ε
static bool gradient_is_small(const StoppingRule& rule, const Minimiser& minimiser) {
  return rule.gradient > 0 && minimiser.gradient_norm() <= rule.gradient;
}

static bool decrease_is_small(const StoppingRule& rule, double objective_before,
                              const Minimiser& minimiser) {
  return rule.decrease > 0 && relative_decrease(objective_before, minimiser) <= rule.decrease;
}

// What is left out of both objectives does not change their difference, but |E^k|.
double relative_decrease(double objective_before, const Minimiser& minimiser) {
  const double objective = minimiser.objective() + minimiser.objective_offset();  // E^k, J
  return (objective_before - minimiser.objective()) / std::max(1.0, std::abs(objective));
}

std::optional<Outcome> stop_at_start(const StoppingRule& rule, const Minimiser& minimiser) {
  if (gradient_is_small(rule, minimiser)) return Outcome{StopReason::gradient, 0};
  return {};
}

std::optional<Outcome> iterate_once(const StoppingRule& rule, Minimiser& minimiser) {
  const double objective_before = rule.decrease > 0 ? minimiser.objective() : 0;  // J
  const bool moved = minimiser.iterate();
  const int k = minimiser.iterations();
  if (!moved) return Outcome{StopReason::rounding, k};
  if (gradient_is_small(rule, minimiser)) return Outcome{StopReason::gradient, k};
  if (decrease_is_small(rule, objective_before, minimiser)) {
    return Outcome{StopReason::decrease, k};
  }
  if (k >= rule.iterations) return Outcome{StopReason::iterations, k};
  return {};
}

Outcome iterate_until(const StoppingRule& rule, Minimiser& minimiser, const Points& p) {
  minimiser.begin(p);
  std::optional<Outcome> outcome = stop_at_start(rule, minimiser);
  while (!outcome) outcome = iterate_once(rule, minimiser);
  return *outcome;
}

}  // namespace mass_spring
