#include "same_set.h"

#include <algorithm>

namespace mass_spring {

bool same_set(Indices a, Indices b) {
  std::sort(a.begin(), a.end());
  std::sort(b.begin(), b.end());
  return a.size() == b.size() && a == b;
}

}  // namespace mass_spring
