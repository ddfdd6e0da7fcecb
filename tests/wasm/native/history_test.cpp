#include "history.h"

#include <doctest/doctest.h>

namespace mass_spring {

TEST_CASE("the latest steps are remembered, as many as fit in number") {
  History history;
  for (int step = 0; step < History::most_steps + 5; ++step) {
    history.push({Points::Constant(1, 3, step), Points::Constant(1, 3, -step)});
  }
  CHECK(history.size() == History::most_steps);
  CHECK(history.latest(1).p_curr(0, 0) == History::most_steps + 4);
  CHECK(history.latest(History::most_steps).p_prev(0, 0) == -5);
  history.drop_latest(10);
  CHECK(history.size() == History::most_steps - 10);
  CHECK(history.latest(1).p_curr(0, 0) == History::most_steps - 6);
  history.clear();
  CHECK(history.size() == 0);
}

TEST_CASE("large steps are remembered as long as they fit in memory") {
  History history;
  const int vertices = static_cast<int>(History::most_bytes / 24 / 8);  // two fill a quarter of it
  for (int step = 0; step < 6; ++step) {
    history.push({Points::Constant(vertices, 3, step), Points::Constant(vertices, 3, step)});
  }
  CHECK(history.size() == 4);
  CHECK(history.latest(1).p_curr(0, 0) == 5);
}

}  // namespace mass_spring
