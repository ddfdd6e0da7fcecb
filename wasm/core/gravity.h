#pragma once

#include "types.h"

namespace mass_spring {

/// The weight of every vertex: row i of f_ext is m_i (0, -acceleration, 0).
/// @param m             #V, kg
/// @param acceleration  m/s²
/// @param f_ext         #V by 3, N (result)
void gravity(const Vector& m, double acceleration, Points& f_ext);

}  // namespace mass_spring
