#include "selection_matrix.h"

namespace mass_spring {

Triplets selection_matrix(const Indices& pinned) {
  Triplets C;
  C.reserve(pinned.size());
  for (int c = 0; c < pinned.size(); ++c) C.emplace_back(c, pinned(c), 1.0);
  return C;
}

}  // namespace mass_spring
