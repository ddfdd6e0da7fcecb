#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "support.h"
#include "validate_iterate.h"
#include "validate_masses.h"
#include "validate_parameters.h"
#include "validate_points.h"
#include "validate_springs.h"
#include "validate_system.h"
#include "validate_vertices.h"

namespace mass_spring {
namespace {

const double nan = std::numeric_limits<double>::quiet_NaN();
const double infinity = std::numeric_limits<double>::infinity();

void check(const Status& status, StatusCode code, const std::string& field, int index,
           double value) {
  CHECK(status.code == code);
  CHECK(status.field == field);
  CHECK(status.index == index);
  if (std::isnan(value)) {
    CHECK(std::isnan(status.value));
  } else {
    CHECK(status.value == value);
  }
}

Status with(double Parameters::* field, double value) {
  Parameters parameters = usual_parameters();
  parameters.*field = value;
  return validate_parameters(parameters);
}

}  // namespace

TEST_CASE("points") {
  CHECK(validate_points("V", {0, 1, 2, 3, 4, 5}, 2).ok());
  check(validate_points("V", {0, 1, 2, 3}, 1), StatusCode::wrong_length, "V", -1, 4);
  check(validate_points("V", {0, 1, 2, 3, nan, 5}, 2), StatusCode::not_finite, "V", 1, nan);
  check(validate_points("V", {0, -infinity, 2}, 1), StatusCode::not_finite, "V", 0, -infinity);
}

TEST_CASE("springs") {
  CHECK(validate_springs({}, 0).ok());
  CHECK(validate_springs({0, 1, 2, 1}, 3).ok());
  check(validate_springs({0, 1, 2}, 3), StatusCode::wrong_length, "E", -1, 3);
  check(validate_springs({0, 1, 1, 3}, 3), StatusCode::index_out_of_range, "E", 1, 3);
  check(validate_springs({-1, 1}, 3), StatusCode::index_out_of_range, "E", 0, -1);
  check(validate_springs({0, 1, 2, 2}, 3), StatusCode::self_spring, "E", 1, 2);
  check(validate_springs({0, 1, 1, 2, 0, 1}, 3), StatusCode::duplicate_spring, "E", 2, 0);
  check(validate_springs({2, 0, 0, 1, 1, 0}, 3), StatusCode::duplicate_spring, "E", 2, 1);
}

TEST_CASE("masses") {
  CHECK(validate_masses({1, 2}, 2).ok());
  check(validate_masses({1}, 2), StatusCode::wrong_length, "m", -1, 1);
  check(validate_masses({1, nan}, 2), StatusCode::not_finite, "m", 1, nan);
  check(validate_masses({0, 1}, 2), StatusCode::not_positive, "m", 0, 0);
}

TEST_CASE("pins") {
  CHECK(validate_vertices("pinned", {2, 0}, 3).ok());
  check(validate_vertices("pinned", {0, 3}, 3), StatusCode::index_out_of_range, "pinned", 1, 3);
  check(validate_vertices("pinned", {-1}, 3), StatusCode::index_out_of_range, "pinned", 0, -1);
  check(validate_vertices("pinned", {1, 2, 1}, 3), StatusCode::duplicate_vertex, "pinned", 2, 0);
}

TEST_CASE("parameters") {
  CHECK(validate_parameters(usual_parameters()).ok());
  CHECK(with(&Parameters::gravity, -1).ok());
  check(with(&Parameters::k, 0), StatusCode::not_positive, "k", -1, 0);
  check(with(&Parameters::delta_t, -0.1), StatusCode::not_positive, "delta_t", -1, -0.1);
  check(with(&Parameters::w, 0), StatusCode::not_positive, "w", -1, 0);
  check(with(&Parameters::mass_scale, 0), StatusCode::not_positive, "mass_scale", -1, 0);
  check(with(&Parameters::k, infinity), StatusCode::not_finite, "k", -1, infinity);
  check(with(&Parameters::gravity, nan), StatusCode::not_finite, "gravity", -1, nan);
  check(with(&Parameters::stop_gradient, -1), StatusCode::negative, "stop_gradient", -1, -1);
  check(with(&Parameters::stop_decrease, -1e-9), StatusCode::negative, "stop_decrease", -1, -1e-9);
  Parameters parameters = usual_parameters();
  parameters.iterations = 0;
  check(validate_parameters(parameters), StatusCode::not_positive, "iterations", -1, 0);
  parameters.iterations = 1000000;
  check(validate_parameters(parameters), StatusCode::too_large, "iterations", -1, 160e6);
}

TEST_CASE("a system too stiff for double precision is refused, with its number and vertex") {
  TimeStep step = corner();
  // Vertex 1: two springs of k, 2 kg, Δt = 0.5 s: κ = 2k·0.25/2 = k/4; vertex 0: one spring, 1 kg:
  // k/4 too, and first.
  step.k = 4e9;
  CHECK(validate_system(step, Storage::sparse).ok());
  step.k = 8e9;
  check(validate_system(step, Storage::sparse), StatusCode::too_stiff, "stiffness_number", 0, 2e9);
  step.k = infinity;
  step.delta_t = 0;
  CHECK(validate_system(step, Storage::sparse).code == StatusCode::too_stiff);
}

TEST_CASE("a dense system beyond the memory is refused, with its bytes") {
  TimeStep step = corner();
  step.m = Vector::Ones(6000);
  CHECK(validate_system(step, Storage::sparse).ok());
  // M and Q, 6000² each, and three rows of A and C
  check(validate_system(step, Storage::dense), StatusCode::too_large, "storage", -1,
        8 * (2 * 36e6 + 3 * 6000));
}

TEST_CASE("an iterate that is not finite") {
  Points p = Points::Zero(3, 3);
  CHECK(validate_iterate(p).ok());
  p(2, 1) = infinity;
  check(validate_iterate(p), StatusCode::diverged, "p", 2, infinity);
}

TEST_CASE("every status has a name") {
  CHECK(status_code_names().size() == static_cast<std::size_t>(StatusCode::on_root) + 1);
  CHECK(status_code_names().back() == "on_root");
}

}  // namespace mass_spring
