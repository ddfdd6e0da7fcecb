#include "elastic_gradient.h"

namespace mass_spring {
namespace {

// m: shorter springs point along x, as in local_step.
constexpr double shortest_with_direction = 1e-150;

void keep_direction(const RowSpring& spring, double length, WidePoint& x, double& divisor) {
  if (length >= shortest_with_direction) return;
  x = {Pair{spring.sense_in_E, 0}, both(0)};
  divisor = 1;
}

/// k(x - d) of two springs, whose square roots and divisions are done together.
struct TwoForces {
  WidePoint of_a, of_b;  // N
  Pair stretches;        // m

  TwoForces(const RowSpring& a, const RowSpring& b, Pair k, const double* p) {
    WidePoint x_a = load_point(p, a.i) - load_point(p, a.j);
    WidePoint x_b = load_point(p, b.i) - load_point(p, b.j);
    const Pair lengths = square_root(sums(half_products(x_a, x_a), half_products(x_b, x_b)));
    stretches = lengths - Pair{a.r, b.r};
    Pair divisors = lengths;
    if (!(lengths[0] >= shortest_with_direction && lengths[1] >= shortest_with_direction)) {
      double divisor_a = lengths[0], divisor_b = lengths[1];
      keep_direction(a, lengths[0], x_a, divisor_a);
      keep_direction(b, lengths[1], x_b, divisor_b);
      divisors = Pair{divisor_a, divisor_b};
    }
    // k(x - d) = k(|x| - r) x/|x|
    const Pair factors = k * stretches / divisors;
    of_a = factors[0] * x_a;
    of_b = factors[1] * x_b;
  }
};

void add_force(const RowSpring& spring, WidePoint force, double* g) {
  store_point(load_point(g, spring.i) + force, g, spring.i);
  store_point(load_point(g, spring.j) - force, g, spring.j);
}

}  // namespace

double add_elastic_gradient(const std::vector<RowSpring>& springs, double k, const WidePoints& p,
                            WidePoints& g) {
  Pair squares = both(0);  // m²
  const std::size_t even = springs.size() / 2 * 2;
  for (std::size_t e = 0; e < even; e += 2) {
    const TwoForces forces(springs[e], springs[e + 1], both(k), p.data());
    squares += forces.stretches * forces.stretches;
    add_force(springs[e], forces.of_a, g.data());
    add_force(springs[e + 1], forces.of_b, g.data());
  }
  double sum_of_squares = sum(squares);
  if (even < springs.size()) {
    const RowSpring& last = springs.back();
    const TwoForces forces(last, last, both(k), p.data());
    sum_of_squares += forces.stretches[0] * forces.stretches[0];
    add_force(last, forces.of_a, g.data());
  }
  return 0.5 * k * sum_of_squares;
}

}  // namespace mass_spring
