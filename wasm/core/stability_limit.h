#pragma once

#include "method.h"

namespace mass_spring {

/// Up to which Δt ω an oscillation of frequency ω whose damping ratio is ζ does not grow; infinite
/// for the methods that are implicit. Of q̈ = -ω² q - 2ζω q̇ the roots of a step, |z| = 1, give
///   symplectic Euler  2(√(1 + ζ²) - ζ), which is 2 without damping,
///   forward Euler     2ζ, from ζ = 1 on 2(ζ - √(ζ² - 1)): without damping none at all.
double stability_limit(Method method, double zeta);

}  // namespace mass_spring
