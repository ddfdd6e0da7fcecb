#include "largest_free_component.h"

namespace mass_spring {

double largest_free_component(const Points& g, const Indices& pinned) {
  Vector largest = g.rowwise().lpNorm<Eigen::Infinity>();  // #V
  for (const int i : pinned) largest(i) = 0;
  return largest.size() == 0 ? 0 : largest.maxCoeff();
}

}  // namespace mass_spring
