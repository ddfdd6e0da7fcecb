#pragma once

#include <string>
#include <vector>

namespace mass_spring {

enum class StatusCode {
  ok,
  no_scene,
  no_vertices,
  wrong_length,
  not_finite,
  index_out_of_range,
  self_spring,
  duplicate_spring,
  duplicate_vertex,
  not_positive,
  negative,
  too_stiff,
  too_large,
  factorisation_failed,
  diverged,
  unstable,
  on_root,
};

/// What a call that can fail returns. Without exceptions in the module, every error is such a
/// value.
struct Status {
  StatusCode code = StatusCode::ok;
  std::string field;  // the argument or quantity at fault, e.g. "E", "m", "delta_t"
  int index = -1;     // its row, or -1
  // The offender: a number, a vertex, bytes, or for a repetition the row it repeats.
  double value = 0;
  double limit = 0;  // the most that value may be, of what is too stiff, too large or unstable

  bool ok() const { return code == StatusCode::ok; }
};

/// The spelling of every StatusCode, in order.
const std::vector<std::string>& status_code_names();

}  // namespace mass_spring
