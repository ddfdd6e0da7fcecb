#pragma once

#include <cstring>

namespace mass_spring {

/// Four floats that are added, multiplied, … together: one register of every machine, like Pair.
using Quad = float __attribute__((vector_size(16)));

/// Four neighbours in memory, at any address.
inline Quad load(const float* values) {
  Quad quad;
  std::memcpy(&quad, values, sizeof quad);
  return quad;
}
inline void store(Quad quad, float* values) { std::memcpy(values, &quad, sizeof quad); }

}  // namespace mass_spring
