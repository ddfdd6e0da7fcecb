#include "external_energy.h"

namespace mass_spring {

double external_energy(const Points& f_ext, const Points& p) {
  return -p.cwiseProduct(f_ext).sum();
}

}  // namespace mass_spring
