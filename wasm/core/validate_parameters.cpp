#include "validate_parameters.h"

#include <cmath>

#include "trace.h"

namespace mass_spring {

// What a trace takes beside the iterates: two half-steps an iteration, each a row of numbers.
constexpr double bytes_per_iteration = 2 * Trace::columns * sizeof(double);
constexpr double largest_trace = 16e6;  // bytes

enum class Sign { any, not_negative, positive };

Status validate_parameters(const Parameters& parameters) {
  const struct {
    const char* field;
    double value;
    Sign sign;
  } rules[] = {
      {"k", parameters.k, Sign::positive},
      {"delta_t", parameters.delta_t, Sign::positive},
      {"w", parameters.w, Sign::positive},
      {"mass_scale", parameters.mass_scale, Sign::positive},
      {"iterations", static_cast<double>(parameters.iterations), Sign::positive},
      {"stop_gradient", parameters.stop_gradient, Sign::not_negative},
      {"stop_decrease", parameters.stop_decrease, Sign::not_negative},
      {"gravity", parameters.gravity, Sign::any},
      {"damping", parameters.damping, Sign::not_negative},
  };
  for (const auto& [field, value, sign] : rules) {
    if (!std::isfinite(value)) return {StatusCode::not_finite, field, -1, value};
    if (sign == Sign::positive && value <= 0) return {StatusCode::not_positive, field, -1, value};
    if (sign == Sign::not_negative && value < 0) return {StatusCode::negative, field, -1, value};
  }
  const double bytes = bytes_per_iteration * parameters.iterations;
  if (bytes > largest_trace) return {StatusCode::too_large, "iterations", -1, bytes, largest_trace};
  return {};
}

}  // namespace mass_spring
