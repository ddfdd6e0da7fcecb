#include "elastic_gradient.h"

namespace mass_spring {
namespace {

using Ends = RowSprings::Ends;

// m: added to every p_i - p_j, so that a collapsed spring points along x, as in local_step, and
// none divides by 0. What it does to any other spring is far below rounding.
const Pair nudge = {0x1p-500, 0};

WidePoint spring_vector(Ends ends, const double* p) {
  WidePoint x = load_point(p, ends.i) - load_point(p, ends.j);
  x.xy += nudge;
  return x;
}

void add_force(Ends ends, WidePoint force, double* g) {
  store_point(load_point(g, ends.i) + force, g, ends.i);
  store_point(load_point(g, ends.j) - force, g, ends.j);
}

/// k(x - d) of two springs, whose square roots and divisions are done together.
struct TwoForces {
  WidePoint of_a, of_b;  // N
  Pair stretches;        // m

  TwoForces(Ends a, Ends b, Pair r, Pair k, const double* p) {
    const WidePoint x_a = spring_vector(a, p), x_b = spring_vector(b, p);
    const Pair lengths = square_root(sums(half_products(x_a, x_a), half_products(x_b, x_b)));
    stretches = lengths - r;
    // k(x - d) = k(|x| - r) x/|x|
    const Pair factors = k * stretches / lengths;
    of_a = factors[0] * x_a;
    of_b = factors[1] * x_b;
  }
};

}  // namespace

double add_elastic_gradient(const RowSprings& springs, double k, const WidePoints& p,
                            WidePoints& g) {
  const std::size_t count = springs.ends.size();
  // For all that the compiler knows, storing to g might change where p, g and the springs are.
  const Ends* ends = springs.ends.data();
  const double* r = springs.r.data();
  const double* p_rows = p.data();
  double* g_rows = g.data();
  Pair squares = both(0);  // m²
  std::size_t e = 0;
  for (; e + 1 < count; e += 2) {
    const Ends a = ends[e], b = ends[e + 1];
    const TwoForces forces(a, b, load(r + e), both(k), p_rows);
    squares += forces.stretches * forces.stretches;
    add_force(a, forces.of_a, g_rows);
    add_force(b, forces.of_b, g_rows);
  }
  double sum_of_squares = sum(squares);
  if (e < count) {
    const Ends last = ends[e];
    const TwoForces forces(last, last, both(r[e]), both(k), p_rows);
    sum_of_squares += forces.stretches[0] * forces.stretches[0];
    add_force(last, forces.of_a, g_rows);
  }
  return 0.5 * k * sum_of_squares;
}

}  // namespace mass_spring
