#include "fast_system.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "spring_direction.h"

namespace mass_spring {

void FastSystem::analyse(const Points& V, const Edges& E, const Vector& r, const Indices& pinned) {
  solver_ = {};  // its memory may be needed for the next
  const int n = static_cast<int>(V.rows());
  free_count_ = n - static_cast<int>(pinned.size());
  row_.assign(n, 0);
  for (const int i : pinned) row_[i] = free_count_;
  std::vector<int> unpinned;  // vertices, in the order of the scene
  int pinned_row = free_count_;
  for (int i = 0; i < n; ++i) {
    if (row_[i] >= free_count_) {
      row_[i] = pinned_row++;  // whatever the order in which pins are listed
      continue;
    }
    row_[i] = static_cast<int>(unpinned.size());
    unpinned.push_back(i);
  }

  std::vector<std::array<int, 2>> edges;
  for (int e = 0; e < E.rows(); ++e) {
    const int i = row_[E(e, 0)], j = row_[E(e, 1)];
    if (std::max(i, j) < free_count_) edges.push_back({i, j});
  }
  const Graph graph = graph_from_edges(free_count_, edges);
  const Points unpinned_V = V(unpinned, Eigen::all);
  pattern_ = symbolic_cholesky(graph, elimination_order(unpinned_V, graph));
  for (int i = 0; i < free_count_; ++i) row_[unpinned[pattern_.order[i]]] = i;

  // What is near in memory is used at nearly the same time.
  const auto rows = [&](int e) { return std::minmax({row_[E(e, 0)], row_[E(e, 1)]}); };
  std::vector<int> sequence(E.rows());
  std::iota(sequence.begin(), sequence.end(), 0);
  std::sort(sequence.begin(), sequence.end(), [&](int e, int f) { return rows(e) < rows(f); });
  springs_ = {};
  held_springs_.clear();
  for (const int e : sequence) {
    springs_.ends.push_back({row_[E(e, 0)], row_[E(e, 1)]});
    springs_.r.push_back(r(e));
    const auto [first, last] = rows(e);
    if (first < free_count_ && last >= free_count_) held_springs_.push_back({first, last});
  }
}

std::vector<int> FastSystem::order() const {
  std::vector<int> vertices(free_count_);
  for (int i = 0; i < static_cast<int>(row_.size()); ++i) {
    if (row_[i] < free_count_) vertices[row_[i]] = i;
  }
  return vertices;
}

bool FastSystem::factorise(const TimeStep& step, const Progress& progress) {
  k_ = step.k;
  coupling_ = coupling(step);
  const Vector& m = step.m;
  inertia_.resize(m.size());
  for (int i = 0; i < m.size(); ++i) inertia_(row_[i]) = m(i) / (step.delta_t * step.delta_t);
  inertia_.tail(m.size() - free_count_).setZero();
  Vector diagonal = inertia_.head(free_count_);
  for (const int i : step.pull.vertices) {
    if (row_[i] < free_count_) diagonal(row_[i]) += step.pull.k;
  }
  for (const auto& [i, j] : springs_.ends) {
    for (const int row : {i, j}) {
      if (row < free_count_) diagonal(row) += coupling_;
    }
  }
  return solver_.factorise(pattern_, coupling_, diagonal, progress);
}

// With s = 2p^t - p^{t-Δt} + f^ext Δt²/m, the inertial prediction, inertia and external energy of a
// vertex are m/(2Δt²)|p - s|² up to what does not depend on p.
void FastSystem::begin(const TimeStep& step) {
  const double squared_delta_t = step.delta_t * step.delta_t;
  inertial_.resize(step.m.size(), 4);
  objective_offset_ = 0;
  for (int i = 0; i < step.m.size(); ++i) {
    const Eigen::RowVector3d carried = step.f_ext.row(i) * (squared_delta_t / step.m(i));  // m
    const Eigen::RowVector3d s = 2 * step.p_curr.row(i) - step.p_prev.row(i) + carried;
    objective_offset_ -= step.f_ext.row(i).dot(s - 0.5 * carried);
    inertial_.row(row_[i]) << s, 0;
  }
  for (int c = 0; c < step.pinned.size(); ++c) {
    const int i = step.pinned(c);
    auto held = inertial_.row(row_[i]);
    const Eigen::RowVector3d moved = step.targets.row(c) - held.head<3>();
    objective_offset_ += 0.5 * step.m(i) / squared_delta_t * moved.squaredNorm();
    held << step.targets.row(c), 0;
  }

  drawn_.clear();
  pull_k_ = step.pull.k;
  for (int c = 0; c < step.pull.vertices.size(); ++c) {
    const auto target = step.pull.targets.row(c);
    drawn_.push_back(
        {row_[step.pull.vertices(c)], {Pair{target.x(), target.y()}, Pair{target.z(), 0}}});
  }
  dashpots_.clear();
  resistance_ = step.damping / step.delta_t;
  if (resistance_ == 0) return;
  const WidePoints p = rows_from_points(step.p_curr);
  for (const auto ends : springs_.ends) {
    const Eigen::RowVector3d x = (p.row(ends.i) - p.row(ends.j)).head<3>();
    const Eigen::Vector3d n = spring_direction(p.row(ends.i).head<3>(), p.row(ends.j).head<3>());
    dashpots_.push_back({ends, {Pair{n.x(), n.y()}, Pair{n.z(), 0}}, x * n});
  }
}

WidePoints FastSystem::rows_from_points(const Points& p) const {
  WidePoints rows(p.rows(), 4);
  for (int i = 0; i < p.rows(); ++i) rows.row(row_[i]) << p.row(i), 0;
  return rows;
}

void FastSystem::points_from_rows(const WidePoints& rows, Points& p) const {
  p.resize(rows.rows(), 3);
  for (int i = 0; i < p.rows(); ++i) p.row(i) = rows.row(row_[i]).head<3>();
}

void FastSystem::hold_pins(WidePoints& p) const {
  const Eigen::Index pinned_count = p.rows() - free_count_;
  p.bottomRows(pinned_count) = inertial_.bottomRows(pinned_count);
}

// ∂E/∂p = M/Δt² (p - s) + k Aᵀ(A p - d(p))
double FastSystem::gradient(const WidePoints& p, WidePoints& g) const {
  g.resizeLike(p);
  Pair inertia = both(0);  // J
  for (int i = 0; i < p.rows(); ++i) {
    const WidePoint away = load_point(p.data(), i) - load_point(inertial_.data(), i);
    const WidePoint force = inertia_(i) * away;
    inertia += half_products(force, away);
    store_point(force, g.data(), i);
  }
  double potential = add_elastic_gradient(springs_, k_, p, g);
  potential += add_dashpot_gradient(p, g) + add_pull_gradient(p, g);
  g.bottomRows(p.rows() - free_count_).setZero();
  return 0.5 * sum(inertia) + potential;
}

/// c/Δt n nᵀ(x - x^t), as damping_energy.h explains it.
/// @return  J
double FastSystem::add_dashpot_gradient(const WidePoints& p, WidePoints& g) const {
  double sum_of_squares = 0;  // m²
  for (const auto& [ends, n, length] : dashpots_) {
    const WidePoint x = load_point(p.data(), ends.i) - load_point(p.data(), ends.j);
    const double lengthening = sum(half_products(n, x)) - length;
    const WidePoint force = (resistance_ * lengthening) * n;
    store_point(load_point(g.data(), ends.i) + force, g.data(), ends.i);
    store_point(load_point(g.data(), ends.j) - force, g.data(), ends.j);
    sum_of_squares += lengthening * lengthening;
  }
  return 0.5 * resistance_ * sum_of_squares;
}

/// k (p - target)
/// @return  J
double FastSystem::add_pull_gradient(const WidePoints& p, WidePoints& g) const {
  double sum_of_squares = 0;  // m²
  for (const auto& [row, target] : drawn_) {
    const WidePoint away = load_point(p.data(), row) - target;
    store_point(load_point(g.data(), row) + pull_k_ * away, g.data(), row);
    sum_of_squares += sum(half_products(away, away));
  }
  return 0.5 * pull_k_ * sum_of_squares;
}

void FastSystem::apply_inverse(WidePoints& g) { solver_.solve(pattern_, g); }

void FastSystem::apply_inverse(RoughPoints& g) { solver_.solve(pattern_, g); }

void FastSystem::iterate(WidePoints& p, int iterations) {
  for (int iteration = 0; iteration < iterations; ++iteration) {
    gradient(p, g_);
    if (iteration == 0) {
      // The local step saw the pins where they were, the global step has them where they are held:
      // in A p, not in d.
      for (const auto& [free, pinned] : held_springs_) {
        g_.row(free) += k_ * (p.row(pinned) - inertial_.row(pinned));
      }
      hold_pins(p);
    }
    apply_inverse(g_);
    p -= g_;
  }
}

}  // namespace mass_spring
