#pragma once

#include <cmath>
#include <cstring>

namespace mass_spring {

/// Two doubles that are added, multiplied, … together: one register of every machine, so that the
/// results are the same bits on all.
using Pair = double __attribute__((vector_size(16)));

inline Pair both(double value) { return Pair{value, value}; }

/// Two neighbours in memory, at any address.
inline Pair load(const double* values) {
  Pair pair;
  std::memcpy(&pair, values, sizeof pair);
  return pair;
}
inline void store(Pair pair, double* values) { std::memcpy(values, &pair, sizeof pair); }

inline Pair square_root(Pair a) { return Pair{std::sqrt(a[0]), std::sqrt(a[1])}; }

inline double sum(Pair a) { return a[0] + a[1]; }

/// (a₀ + a₁, b₀ + b₁)
inline Pair sums(Pair a, Pair b) {
  return __builtin_shufflevector(a, b, 0, 2) + __builtin_shufflevector(a, b, 1, 3);
}

}  // namespace mass_spring
