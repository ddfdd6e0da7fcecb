#pragma once

#include <vector>

#include "pair.h"

namespace mass_spring {

/// A point, padded to two registers: an entry of a matrix meets its three coordinates in two
/// multiplications. The fourth number stays 0.
struct WidePoint {
  Pair xy = both(0);
  Pair z0 = both(0);
};

/// One point a row, like Points.
using WidePoints = std::vector<WidePoint>;

inline WidePoint operator+(WidePoint a, WidePoint b) { return {a.xy + b.xy, a.z0 + b.z0}; }
inline WidePoint operator-(WidePoint a, WidePoint b) { return {a.xy - b.xy, a.z0 - b.z0}; }
inline WidePoint operator*(double factor, WidePoint a) {
  return {both(factor) * a.xy, both(factor) * a.z0};
}
inline WidePoint& operator+=(WidePoint& a, WidePoint b) { return a = a + b; }
inline WidePoint& operator-=(WidePoint& a, WidePoint b) { return a = a - b; }

/// Two numbers whose sum is the scalar product.
inline Pair half_products(WidePoint a, WidePoint b) { return a.xy * b.xy + a.z0 * b.z0; }

}  // namespace mass_spring
