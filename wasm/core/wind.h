#pragma once

#include "types.h"

namespace mass_spring {

/// Adds the course's wind, gusts travelling along x, read as an acceleration so that it keeps its
/// ratio to gravity whatever the masses (docs/decisions/0102). With the phase φ = x/D + time (in
/// seconds), in m/s²: x: 3 + 1.5(1 + cos 5φ), y: cos(0.3 + φ), z: sin φ.
/// @param m       #V, kg
/// @param extent  D, m: diagonal of the bounding box of the rest positions
/// @param time    s
/// @param p       #V by 3, m
/// @param f_ext   #V by 3, N (added to)
void wind(const Vector& m, double extent, double time, const Points& p, Points& f_ext);

}  // namespace mass_spring
