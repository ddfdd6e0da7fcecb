#include "simulation.h"

#include <doctest/doctest.h>

#include <cstring>
#include <vector>

#include "support.h"

namespace mass_spring {
namespace {

/// A chain of n vertices along x, 0.5 m apart, 1 kg each, the first one pinned.
Status hang_chain(Simulation& simulation, int n, const Parameters& parameters) {
  std::vector<double> V;
  std::vector<int> E;
  for (int i = 0; i < n; ++i) V.insert(V.end(), {0.5 * i, 0, 0});
  for (int i = 1; i < n; ++i) E.insert(E.end(), {i - 1, i});
  return simulation.set_scene(V, E, std::vector<double>(n, 1), {0}, parameters);
}

}  // namespace

TEST_CASE("without a scene every call says so, and every question has an empty answer") {
  Simulation simulation;
  for (const Status& status :
       {simulation.set_parameters(usual_parameters()), simulation.set_pins({}, {}),
        simulation.reset(), simulation.set_state(1, {}, {}, 0), simulation.step(),
        simulation.seek(0), simulation.next_step()}) {
    CHECK(status.code == StatusCode::no_scene);
  }
  CHECK_FALSE(simulation.previous_step());
  CHECK_FALSE(simulation.back_to(0));
  CHECK(simulation.iterate().p.size() == 0);
  CHECK(simulation.gradient_at({}).size() == 0);
  CHECK(simulation.Q().empty());
  CHECK(simulation.stiffness_number() == 0);
  CHECK(std::isnan(simulation.probe_vertex(0).b(0)));
  CHECK(std::isnan(simulation.objective_at({}).objective));
}

TEST_CASE("a first scene that fails leaves none") {
  Simulation simulation;
  Parameters parameters = usual_parameters();
  parameters.delta_t = 1e-170;  // whose square is zero: M/Δt² is infinite
  CHECK(hang_chain(simulation, 3, parameters).code == StatusCode::factorisation_failed);
  CHECK(simulation.step().code == StatusCode::no_scene);
  CHECK(simulation.y().size() == 0);
}

TEST_CASE("a factorisation that fails leaves the one before") {
  Simulation simulation, undisturbed;
  REQUIRE(hang_chain(simulation, 4, usual_parameters()).ok());
  REQUIRE(hang_chain(undisturbed, 4, usual_parameters()).ok());
  Parameters parameters = usual_parameters();
  parameters.delta_t = 1e-170;
  CHECK(simulation.set_parameters(parameters).code == StatusCode::factorisation_failed);
  CHECK(hang_chain(simulation, 7, parameters).code == StatusCode::factorisation_failed);
  REQUIRE(simulation.step().ok());
  REQUIRE(undisturbed.step().ok());
  CHECK(simulation.iterate().p == undisturbed.iterate().p);
}

TEST_CASE("a step that diverges leaves the state before, and says where") {
  Simulation simulation;
  REQUIRE(hang_chain(simulation, 3, usual_parameters()).ok());
  REQUIRE(simulation.step().ok());
  const Points accepted = simulation.iterate().p;
  REQUIRE(simulation.set_pins({0}, {1e300, 0, 0}).ok());  // times w it overflows
  const Points y = simulation.y();
  for (const Status& status : {simulation.step(), simulation.seek(5), simulation.step()}) {
    CHECK(status.code == StatusCode::diverged);
    CHECK(status.field == "p");
    CHECK(status.index == 0);
  }
  CHECK(simulation.iterate().p == accepted);
  CHECK(simulation.step_number() == 1);
  CHECK(simulation.half_step() == simulation.last_half_step());
  REQUIRE(simulation.set_pins({0}, {0, 0, 0}).ok());
  CHECK(simulation.step().ok());
}

TEST_CASE("a drag inside a time step that diverges is undone") {
  Simulation simulation;
  REQUIRE(hang_chain(simulation, 3, usual_parameters()).ok());
  REQUIRE(simulation.seek(4).ok());
  const Points p = simulation.iterate().p, y = simulation.y();
  const std::vector<double> rows = simulation.trace().rows();
  CHECK(simulation.set_pins({0}, {1e300, 0, 0}).code == StatusCode::diverged);
  CHECK(simulation.time_step().targets == Points::Zero(1, 3));
  CHECK(simulation.iterate().p == p);
  CHECK(simulation.y() == y);
  const std::vector<double>& restored = simulation.trace().rows();
  REQUIRE(restored.size() == rows.size());
  // By bits: a residual that is not a number is unlike itself.
  CHECK(std::memcmp(restored.data(), rows.data(), rows.size() * sizeof(double)) == 0);
}

TEST_CASE("the same pins in another order keep their targets") {
  Simulation simulation, reordered;
  REQUIRE(hang_chain(simulation, 3, usual_parameters()).ok());
  REQUIRE(hang_chain(reordered, 3, usual_parameters()).ok());
  REQUIRE(simulation.set_pins({0, 2}, {0, 0, 0, 1, 0.5, 0}).ok());
  REQUIRE(reordered.set_pins({0, 2}, {0, 0, 0, 1, 0, 0}).ok());
  REQUIRE(reordered.set_pins({2, 0}, {1, 0.5, 0, 0, 0, 0}).ok());
  CHECK(reordered.factorisation_count() == 2);
  REQUIRE(simulation.step().ok());
  REQUIRE(reordered.step().ok());
  CHECK(simulation.iterate().p == reordered.iterate().p);
}

TEST_CASE("iterates that would fill the memory are computed again when returned to") {
  // 4000 vertices · 24 bytes · 1000 iterations are 96 MB, three times what a trace keeps.
  Parameters parameters = usual_parameters();
  parameters.iterations = 1000;
  Simulation simulation;
  REQUIRE(hang_chain(simulation, 4000, parameters).ok());
  std::vector<Iterate> forwards;
  for (const int half_step : {9, 10, 11, 12, 13, 14, 15}) {
    REQUIRE(simulation.seek(half_step).ok());
    forwards.push_back(simulation.iterate());
  }
  for (const int half_step : {15, 12, 10, 9, 14}) {
    REQUIRE(simulation.seek(half_step).ok());
    CHECK(simulation.iterate().p == forwards[half_step - 9].p);
    CHECK(simulation.iterate().p_before == forwards[half_step - 9].p_before);
    CHECK(simulation.iterate().d == forwards[half_step - 9].d);
  }
}

}  // namespace mass_spring
