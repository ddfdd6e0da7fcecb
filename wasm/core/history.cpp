#include "history.h"

#include <utility>

namespace mass_spring {

void History::push(Departure departure) {
  // Every step of a scene takes as many.
  const std::size_t bytes = sizeof(double) * (departure.p_curr.size() + departure.p_prev.size());
  steps_.push_back(std::move(departure));
  while (size() > most_steps || size() * bytes > most_bytes) steps_.pop_front();
}

}  // namespace mass_spring
