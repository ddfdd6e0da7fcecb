#pragma once

#include <Eigen/Core>

#include "pair.h"
#include "quad.h"

namespace mass_spring {

/// #V by 4: one point a row, like Points, and a 0.
template <typename Scalar>
using WideRows = Eigen::Matrix<Scalar, Eigen::Dynamic, 4, Eigen::RowMajor>;
using WidePoints = WideRows<double>;
/// For changes of positions and for forces, where seven digits will do.
using RoughPoints = WideRows<float>;

/// A row of WidePoints in two registers: an entry of a matrix meets its three coordinates in two
/// multiplications. In floats it is a Quad, and one will do.
struct WidePoint {
  Pair xy = both(0);
  Pair z0 = both(0);
};

/// @param rows  of WideRows
inline WidePoint load_point(const double* rows, int i) {
  return {load(rows + 4 * i), load(rows + 4 * i + 2)};
}
inline Quad load_point(const float* rows, int i) { return load(rows + 4 * i); }

inline void store_point(WidePoint a, double* rows, int i) {
  store(a.xy, rows + 4 * i);
  store(a.z0, rows + 4 * i + 2);
}
inline void store_point(Quad a, float* rows, int i) { store(a, rows + 4 * i); }

inline WidePoint operator+(WidePoint a, WidePoint b) { return {a.xy + b.xy, a.z0 + b.z0}; }
inline WidePoint operator-(WidePoint a, WidePoint b) { return {a.xy - b.xy, a.z0 - b.z0}; }
inline WidePoint operator*(double factor, WidePoint a) {
  return {both(factor) * a.xy, both(factor) * a.z0};
}
inline WidePoint& operator+=(WidePoint& a, WidePoint b) { return a = a + b; }

/// Two numbers whose sum is the scalar product.
inline Pair half_products(WidePoint a, WidePoint b) { return a.xy * b.xy + a.z0 * b.z0; }

}  // namespace mass_spring
