#include "validate_system.h"

#include "stiffness_numbers.h"

namespace mass_spring {

// Dimensionless: solving costs about log10 κ of a double's 16 digits, and 1e-7 of the scene's size
// must remain.
constexpr double largest_stiffness_number = 1e9;
// Bytes: the module may grow to 512 MB (CMakeLists.txt), and the history and the trace want their
// share.
constexpr double largest_dense_storage = 450e6;

Status validate_system(const TimeStep& step, Storage storage) {
  int vertex;
  const double stiffness_number =
      stiffness_numbers(step.E, step.k, step.m, step.delta_t).maxCoeff(&vertex);
  // Written so that NaN, from numbers beyond a double's range, is refused too.
  if (!(stiffness_number <= largest_stiffness_number)) {
    return {StatusCode::too_stiff, "stiffness_number", vertex, stiffness_number,
            largest_stiffness_number};
  }
  const double n = static_cast<double>(step.m.size());
  const double rows = static_cast<double>(step.E.rows() + step.pinned.size());  // of A and C
  const double bytes = sizeof(double) * (rows * n + 2 * n * n);                 // A and C, M and Q
  if (storage == Storage::dense && bytes > largest_dense_storage) {
    return {StatusCode::too_large, "storage", -1, bytes, largest_dense_storage};
  }
  return {};
}

}  // namespace mass_spring
