#pragma once

#include "method.h"

namespace mass_spring {

enum class Storage { sparse, dense };

/// How a time step is computed: `plain` by the readable functions, which penalise pins; `fast` by
/// FastSystem, which holds them exactly.
enum class Path { fast, plain };

struct Parameters {
  double k = 0;           // N/m: spring stiffness
  double delta_t = 0;     // s: time step
  double w = 0;           // N/m: pin penalty
  double mass_scale = 1;  // dimensionless: multiplies every mass of the scene
  int iterations = 0;     // K: the most iterations of a time step
  Method method = Method::local_global;
  double stop_gradient = 0;  // N: as in StoppingRule
  double stop_decrease = 0;  // dimensionless
  double gravity = 0;        // m/s^2: g = (0, -gravity, 0)
  double damping = 0;        // c, N s/m: of a dashpot beside every spring
  bool wind = false;
  Path path = Path::plain;
  Storage storage = Storage::sparse;  // of the plain path
};

/// The fast path keeps the matrices that it shows sparse.
inline Storage storage_in_use(const Parameters& parameters) {
  return parameters.path == Path::fast ? Storage::sparse : parameters.storage;
}

inline bool operator==(const Parameters& a, const Parameters& b) {
  return a.k == b.k && a.delta_t == b.delta_t && a.w == b.w && a.mass_scale == b.mass_scale &&
         a.iterations == b.iterations && a.method == b.method &&
         a.stop_gradient == b.stop_gradient && a.stop_decrease == b.stop_decrease &&
         a.gravity == b.gravity && a.damping == b.damping && a.wind == b.wind && a.path == b.path &&
         a.storage == b.storage;
}

}  // namespace mass_spring
