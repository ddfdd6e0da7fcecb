// How fast one core of this machine reads memory: sums of arrays that fit its caches, and of one
// that does not.
//
// Writes one JSON array to stdout: [{"size": MB, "speed": GB/s}, …].
#include <Eigen/Core>
#include <algorithm>
#include <chrono>
#include <cstdio>

namespace {

constexpr double read_each_time = 2e9;  // bytes: some tenths of a second

/// @return GB/s, the best of five rounds
double speed(const Eigen::VectorXd& array) {
  const double bytes = sizeof(double) * static_cast<double>(array.size());
  const int repetitions = static_cast<int>(read_each_time / bytes) + 1;
  volatile double sum = 0;  // so that no reading is left out
  double best = 0;
  for (int round = 0; round < 5; ++round) {
    const auto start = std::chrono::steady_clock::now();
    for (int repetition = 0; repetition < repetitions; ++repetition) sum = sum + array.sum();
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    best = std::max(best, 1e-9 * bytes * repetitions / seconds.count());
  }
  return best;
}

}  // namespace

int main() {
  const char* separator = "[";
  for (const double size : {0.5, 4.0, 16.0, 256.0}) {  // MB
    const Eigen::VectorXd array = Eigen::VectorXd::Ones(static_cast<int>(1e6 * size / 8));
    std::printf("%s{\"size\":%g,\"speed\":%.3g}", separator, size, speed(array));
    separator = ",";
  }
  std::printf("]\n");
}
