#pragma once

#include "types.h"

namespace mass_spring {

/// Springs of rest length 0 that pull vertices, each towards a point of its own.
struct Pull {
  Indices vertices;  // #pulled
  Points targets;    // #pulled by 3, m
  double k = 0;      // N/m
};

/// All that one time step is given. Its objective E(p) is a function of this and of the positions p
/// it looks for.
struct TimeStep {
  Edges E;             // #E by 2
  Vector r;            // #E, m: rest lengths
  Vector m;            // #V, kg
  double k = 0;        // N/m
  double delta_t = 0;  // s
  double w = 0;        // N/m
  double damping = 0;  // c, N s/m: of the dashpot beside every spring
  Indices pinned;      // #pinned
  Points targets;      // #pinned by 3, m: where each pinned vertex is held
  Pull pull;
  Points p_prev;  // #V by 3, m: p at t - Δt
  Points p_curr;  // #V by 3, m: p at t
  Points f_ext;   // #V by 3, N
};

/// N/m: how stiffly Q couples the ends of a spring, k + c/Δt.
inline double coupling(const TimeStep& step) { return step.k + step.damping / step.delta_t; }

/// Where the iteration stands.
struct Iterate {
  Points p;         // #V by 3, m
  Points p_before;  // #V by 3, m: the iterate before p
  Points d;         // #E by 3, m: the latest projection of the springs
};

/// Intermediate results of a time step; the caller keeps them, so that an iteration allocates
/// nothing.
struct Workspace {
  Points y;       // #V by 3, N: the part of b that stays the same during a time step
  Points b;       // #V by 3, N: the right-hand side of the latest global step
  DenseMatrix x;  // #V by 3, m: the solution in the order of the factor
};

}  // namespace mass_spring
