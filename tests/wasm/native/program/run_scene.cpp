// Runs a scene from rest with the core as built natively, for determinism.test.ts to compare bits
// with. stdin: the numbers of vertices, springs, pins and steps; k, delta_t, w, mass_scale,
// iterations, gravity, whether dense, whether fast, the method's number; then V, E, m and the pins.
// stdout: the positions, to the last bit.

#include <cstdio>
#include <iostream>
#include <vector>

#include "simulation.h"

using namespace mass_spring;

namespace {

template <typename Number>
std::vector<Number> read(int count) {
  std::vector<Number> values(count);
  for (Number& value : values) std::cin >> value;
  return values;
}

}  // namespace

int main() {
  const std::vector<int> counts = read<int>(4);
  Parameters parameters;
  bool dense, fast;
  int method;
  std::cin >> parameters.k >> parameters.delta_t >> parameters.w >> parameters.mass_scale >>
      parameters.iterations >> parameters.gravity >> dense >> fast >> method;
  parameters.storage = dense ? Storage::dense : Storage::sparse;
  parameters.path = fast ? Path::fast : Path::plain;
  parameters.method = static_cast<Method>(method);
  const auto V = read<double>(3 * counts[0]);
  const auto E = read<int>(2 * counts[1]);
  const auto m = read<double>(counts[0]);
  const auto pinned = read<int>(counts[2]);
  if (!std::cin) return 1;

  Simulation simulation;
  if (!simulation.set_scene(V, E, m, pinned, parameters).ok()) return 1;
  for (int step = 0; step < counts[3]; ++step) {
    if (!simulation.step().ok()) return 1;
  }
  for (const double coordinate : simulation.iterate().p.reshaped<Eigen::RowMajor>()) {
    std::printf("%.17g\n", coordinate);
  }
  return 0;
}
