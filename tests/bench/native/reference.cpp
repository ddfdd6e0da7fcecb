// An independent implementation of the fast mass-springs time step, written from the formulas
// alone: it shares no code with wasm/core, which is compared with it (agreement, speed).
//
// Reads from stdin, as text separated by white space, matrices row by row:
//   #V #E #pinned steps iterations k[N/m] delta_t[s] w[N/m] gravity[m/s²]
//   V (#V by 3, m)   E (#E by 2)   m (#V, kg)   pinned (#pinned)
// Writes one JSON object to stdout: {"p": [x, y, z, …], "nonzeros": of L, "precompute": ms,
// "refactorise": ms, "stepTimes": [ms, …]}.
#include <Eigen/Sparse>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <vector>

using Points = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;
using SparseMatrix = Eigen::SparseMatrix<double>;
using Triplets = std::vector<Eigen::Triplet<double>>;

namespace {

SparseMatrix from_triplets(int rows, int columns, const Triplets& triplets) {
  SparseMatrix matrix(rows, columns);
  matrix.setFromTriplets(triplets.begin(), triplets.end());
  return matrix;
}

double milliseconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
      .count();
}

}  // namespace

int main() {
  int vertex_count, spring_count, pinned_count, steps, iterations;
  double k, delta_t, w, gravity;
  std::cin >> vertex_count >> spring_count >> pinned_count >> steps >> iterations;
  std::cin >> k >> delta_t >> w >> gravity;

  Points V(vertex_count, 3);                                 // m
  Eigen::Matrix<int, Eigen::Dynamic, 2> E(spring_count, 2);  // rows of V
  Eigen::VectorXd m(vertex_count);                           // kg
  Eigen::VectorXi pinned(pinned_count);                      // rows of V
  for (int i = 0; i < vertex_count; ++i) std::cin >> V(i, 0) >> V(i, 1) >> V(i, 2);
  for (int e = 0; e < spring_count; ++e) std::cin >> E(e, 0) >> E(e, 1);
  for (int i = 0; i < vertex_count; ++i) std::cin >> m(i);
  for (int c = 0; c < pinned_count; ++c) std::cin >> pinned(c);
  if (!std::cin) {
    std::fputs("reference: the scene on stdin is incomplete\n", stderr);
    return 1;
  }

  const auto precomputation = std::chrono::steady_clock::now();
  Triplets incidence, mass, selection;
  Eigen::VectorXd r(spring_count);  // m
  for (int e = 0; e < spring_count; ++e) {
    incidence.emplace_back(e, E(e, 0), 1.0);
    incidence.emplace_back(e, E(e, 1), -1.0);
    r(e) = (V.row(E(e, 0)) - V.row(E(e, 1))).norm();
  }
  for (int i = 0; i < vertex_count; ++i) mass.emplace_back(i, i, m(i));
  for (int c = 0; c < pinned_count; ++c) selection.emplace_back(c, pinned(c), 1.0);
  const SparseMatrix A = from_triplets(spring_count, vertex_count, incidence);  // #E by #V
  const SparseMatrix M = from_triplets(vertex_count, vertex_count, mass);       // #V by #V, kg
  const SparseMatrix C = from_triplets(pinned_count, vertex_count, selection);  // #pinned by #V
  const SparseMatrix At = A.transpose();
  const SparseMatrix AtA = At * A;
  const SparseMatrix CtC = C.transpose() * C;

  // Q = k AᵀA + M/Δt² + w CᵀC
  const auto system_matrix = [&](double stiffness) -> SparseMatrix {
    return stiffness * AtA + M / (delta_t * delta_t) + w * CtC;  // #V by #V, N/m
  };
  Eigen::SimplicialLLT<SparseMatrix> factorisation(system_matrix(k));
  if (factorisation.info() != Eigen::Success) {
    std::fputs("reference: Q has no Cholesky factorisation\n", stderr);
    return 1;
  }
  const double precompute = milliseconds_since(precomputation);  // ms

  Points f_ext = Points::Zero(vertex_count, 3);  // N
  f_ext.col(1) = -gravity * m;
  Points p_prev = V, p_curr = V, p = V, d(spring_count, 3);  // m
  std::vector<double> step_times;                            // ms
  for (int step = 0; step < steps; ++step) {
    const auto start = std::chrono::steady_clock::now();
    // y = M (2 p^t - p^{t-Δt})/Δt² + f^ext + w CᵀC p^target
    const Points y = M * (2 * p_curr - p_prev) / (delta_t * delta_t) + f_ext + w * (CtC * V);
    p = p_curr;
    for (int iteration = 0; iteration < iterations; ++iteration) {
      // d_ij = r_ij (p_i - p_j)/‖p_i - p_j‖
      d.noalias() = A * p;
      d.array().colwise() *= r.array() / d.rowwise().norm().array();
      // Q p = k Aᵀd + y
      p = factorisation.solve(k * (At * d) + y);
    }
    p_prev = p_curr;
    p_curr = p;
    step_times.push_back(milliseconds_since(start));
  }

  const Eigen::Index nonzeros = factorisation.matrixL().nestedExpression().nonZeros();

  const auto refactorisation = std::chrono::steady_clock::now();
  factorisation.factorize(system_matrix(2 * k));
  const double refactorise = milliseconds_since(refactorisation);  // ms

  std::printf("{\"p\":[");
  for (int i = 0; i < p.size(); ++i) std::printf(i ? ",%.17g" : "%.17g", p.data()[i]);
  std::printf("],\"nonzeros\":%td,\"precompute\":%g,\"refactorise\":%g,\"stepTimes\":[", nonzeros,
              precompute, refactorise);
  for (std::size_t s = 0; s < step_times.size(); ++s) std::printf(s ? ",%g" : "%g", step_times[s]);
  std::printf("]}\n");
}
