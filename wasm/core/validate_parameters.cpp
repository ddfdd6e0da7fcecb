#include "validate_parameters.h"

#include <cmath>

#include "trace.h"

namespace mass_spring {

// What a trace takes beside the iterates: two half-steps an iteration, each a row of numbers.
constexpr double bytes_per_iteration = 2 * Trace::columns * sizeof(double);
constexpr double largest_trace = 16e6;  // bytes

Status validate_parameters(const Parameters& parameters) {
  const struct {
    const char* field;
    double value;
    bool positive;
  } rules[] = {
      {"k", parameters.k, true},
      {"delta_t", parameters.delta_t, true},
      {"w", parameters.w, true},
      {"mass_scale", parameters.mass_scale, true},
      {"iterations", static_cast<double>(parameters.iterations), true},
      {"gravity", parameters.gravity, false},
  };
  for (const auto& rule : rules) {
    if (!std::isfinite(rule.value)) return {StatusCode::not_finite, rule.field, -1, rule.value};
    if (rule.positive && rule.value <= 0)
      return {StatusCode::not_positive, rule.field, -1, rule.value};
  }
  const double bytes = bytes_per_iteration * parameters.iterations;
  if (bytes > largest_trace) return {StatusCode::too_large, "iterations", -1, bytes};
  return {};
}

}  // namespace mass_spring
