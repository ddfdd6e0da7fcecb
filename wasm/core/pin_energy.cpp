#include "pin_energy.h"

namespace mass_spring {

double pin_energy(const Indices& pinned, const Points& targets, double w, const Points& p) {
  double energy = 0;
  for (int c = 0; c < pinned.size(); ++c)
    energy += 0.5 * w * (p.row(pinned(c)) - targets.row(c)).squaredNorm();
  return energy;
}

}  // namespace mass_spring
