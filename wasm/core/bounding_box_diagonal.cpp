#include "bounding_box_diagonal.h"

namespace mass_spring {

double bounding_box_diagonal(const Points& p) {
  return (p.colwise().maxCoeff() - p.colwise().minCoeff()).norm();
}

}  // namespace mass_spring
