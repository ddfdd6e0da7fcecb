#include "history.h"

#include <utility>

namespace mass_spring {

void History::push(Points p) {
  const std::size_t bytes = sizeof(double) * p.size();  // every step of a scene takes as many
  steps_.push_back(std::move(p));
  while (size() > most_steps || size() * bytes > most_bytes) steps_.pop_front();
}

}  // namespace mass_spring
