#include "reach_of.h"

#include <algorithm>

namespace mass_spring {

double reach_of(const Points& V) { return 1e6 * std::max(1.0, V.cwiseAbs().maxCoeff()); }

}  // namespace mass_spring
