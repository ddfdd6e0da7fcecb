#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "standing.h"

namespace mass_spring {

enum class StopReason { iterations, gradient, decrease, rounding };

/// When to stop iterating: always after `iterations`, earlier where a threshold is given.
struct StoppingRule {
  int iterations;  // K
  // N: stop once no component of ∂E/∂p is larger. With pins of penalty w its rounding stays at
  // about w |p| 1e-16, which no iteration gets below.
  std::optional<double> gradient;
  // ε: stop once an iteration lowers E by no more than ε max(1 J, |E|).
  std::optional<double> decrease;
};

struct Outcome {
  StopReason reason;
  int iterations;  // how many moved p
};

/// Does ‖∂E/∂p‖∞ ≤ ε?
template <typename Field>
bool gradient_is_small(const StoppingRule& rule, const Standing<Field>& standing) {
  return rule.gradient && standing.gradient.cwiseAbs().maxCoeff() <= *rule.gradient;
}

/// Does E^{k-1} - E^k ≤ ε max(1 J, |E^k|)?
template <typename Field>
bool decrease_is_small(const StoppingRule& rule, const Standing<Field>& standing,
                       double objective_before) {
  return rule.decrease && objective_before - standing.objective <=
                              *rule.decrease * std::max(1.0, std::abs(standing.objective));
}

/// Runs a method from p until the rule says stop or it moves no further.
/// @param method  LocalGlobal, Chebyshev, Anderson or Lbfgs over Problem; or Newton, whose problem
/// is a TimeStep
/// @param p  (updated)
template <typename Method, typename Problem, typename Field>
Outcome iterate_until(const StoppingRule& rule, Method& method, Problem& problem, Field& p) {
  method.begin(problem, p);
  if (gradient_is_small(rule, method.standing())) return {StopReason::gradient, 0};
  for (int iteration = 1; iteration <= rule.iterations; ++iteration) {
    const double objective_before = method.standing().objective;
    if (!method.iterate(problem, p)) return {StopReason::rounding, iteration - 1};
    if (gradient_is_small(rule, method.standing())) return {StopReason::gradient, iteration};
    if (decrease_is_small(rule, method.standing(), objective_before)) {
      return {StopReason::decrease, iteration};
    }
  }
  return {StopReason::iterations, rule.iterations};
}

}  // namespace mass_spring
