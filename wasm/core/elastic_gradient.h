#pragma once

#include <vector>

#include "wide_point.h"

namespace mass_spring {

/// A spring between two rows of the positions.
struct RowSpring {
  int i, j;           // i < j
  double r;           // m: rest length
  double sense_in_E;  // 1, or -1 where E has j before i
};

/// Local step and assembly in one pass, without storing d: adds k Aᵀ(A p - d(p)) to g.
/// @param k  N/m
/// @param p  m
/// @param g  N, as many rows (added to)
/// @return  Σ ½k(|p_i - p_j| - r_ij)², J
double add_elastic_gradient(const std::vector<RowSpring>& springs, double k, const WidePoints& p,
                            WidePoints& g);

}  // namespace mass_spring
