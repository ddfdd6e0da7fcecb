#pragma once

#include <vector>

#include "wide_point.h"

namespace mass_spring {

/// Springs between rows of the positions.
struct RowSprings {
  struct Ends {
    int i, j;
  };
  std::vector<Ends> ends;  // #E, as E has them
  std::vector<double> r;   // #E, m: rest lengths
};

/// Local step and assembly in one pass, without storing d: adds k Aᵀ(A p - d(p)) to g.
/// @param k  N/m
/// @param p  m
/// @param g  N, as many rows (added to)
/// @return  Σ ½k(|p_i - p_j| - r_ij)², J
double add_elastic_gradient(const RowSprings& springs, double k, const WidePoints& p,
                            WidePoints& g);

}  // namespace mass_spring
