#include "mechanical_energy.h"

#include <doctest/doctest.h>

#include "gravity.h"

namespace mass_spring {

TEST_CASE("mechanical energy of two masses on a stretched, moving spring, by hand") {
  TimeStep step;
  step.E = (Edges(1, 2) << 0, 1).finished();
  step.r = Vector::Constant(1, 0.5);
  step.m = Eigen::Vector2d(1, 3);
  step.k = 8;
  step.delta_t = 0.5;
  gravity(step.m, 10, step.f_ext);
  const Points before = (Points(2, 3) << 0, 0, 0, 2, 1, 0).finished();
  const Points now = (Points(2, 3) << 0, 1, 0, 1.5, 1, 0).finished();
  const MechanicalEnergy energy = mechanical_energy(step, now, before);
  CHECK(energy.kinetic == 0.5 * 1 * 4 + 0.5 * 3 * 1);  // v = (0, 2, 0) and (-1, 0, 0) m/s
  CHECK(energy.springs == 0.5 * 8 * 1);                // 1.5 m long instead of 0.5 m
  CHECK(energy.external == 10 * (1 * 1 + 3 * 1));      // m g h
}

}  // namespace mass_spring
