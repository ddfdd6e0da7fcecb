#include "system.h"

#include <limits>

#include "anderson.h"
#include "chebyshev.h"
#include "fast_mass_springs_precomputation_dense.h"
#include "fast_mass_springs_precomputation_sparse.h"
#include "fast_mass_springs_step_dense.h"
#include "fast_mass_springs_step_sparse.h"
#include "fast_problem.h"
#include "forward_euler.h"
#include "global_step.h"
#include "inertial_right_hand_side.h"
#include "lbfgs.h"
#include "linearly_implicit_euler.h"
#include "local_global.h"
#include "local_step.h"
#include "matrix_from_triplets.h"
#include "minimiser_on.h"
#include "newton.h"
#include "plain_problem.h"
#include "right_hand_side.h"
#include "same_set.h"
#include "selection_matrix.h"
#include "single_step.h"
#include "sparse_matrices.h"
#include "symplectic_euler.h"
#include "system_matrix.h"
#include "system_product.h"
#include "triplets_from_matrix.h"

namespace mass_spring {

namespace {

// Bytes, beyond which a factor is refused before work starts. Of Q: 15 million numbers on the fast
// path, with which an iteration takes some 20 ms. Of the Hessian, for the time of a step: the
// module may grow to 512 MB (CMakeLists.txt), and the rest of a scene wants its share.
constexpr double largest_factor = 180e6;
constexpr double largest_newton_factor = 300e6;

const double nan = std::numeric_limits<double>::quiet_NaN();
const Status not_positive_definite = {StatusCode::factorisation_failed, "Q", -1, nan};

}  // namespace

void System::clear(const Parameters& parameters) {
  fast_.reset();
  analysed_ = false;
  if (storage_in_use(parameters) == Storage::dense) {
    precomputation_.emplace<DensePrecomputation>();
  } else {
    precomputation_.emplace<SparsePrecomputation>();
  }
  if (parameters.path == Path::fast) fast_.emplace();
}

Status System::precompute(const Points& V, const TimeStep& step, Vector& r) {
  const auto status = [](bool done) { return done ? Status{} : not_positive_definite; };
  const bool plain_terms = step.damping == 0 && step.pull.vertices.size() == 0;
  const auto factorised = [&](bool done, auto& Q) {
    if (!plain_terms) done = Q.factorise(static_cast<int>(V.rows()), system_matrix(step));
    return status(done);
  };
  const bool needs_order = fast_ && !(analysed_ && same_set(analysed_pins_, step.pinned));
  progress_(needs_order ? "ordering" : "factorising", 0);
  if (auto* dense = std::get_if<DensePrecomputation>(&precomputation_)) {
    return factorised(fast_mass_springs_precomputation_dense(V, step.E, step.k, step.m, step.pinned,
                                                             step.delta_t, step.w, r, *dense),
                      dense->Q);
  }
  auto& sparse = std::get<SparsePrecomputation>(precomputation_);
  if (!fast_) {
    return factorised(fast_mass_springs_precomputation_sparse(
                          V, step.E, step.k, step.m, step.pinned, step.delta_t, step.w, r, sparse),
                      sparse.Q);
  }
  sparse_matrices(V, step.E, step.m, step.pinned, r, sparse);
  if (needs_order) {
    fast_->analyse(V, step.E, r, step.pinned);
    analysed_pins_ = step.pinned;
    analysed_ = true;
  }
  const double bytes = static_cast<double>(fast_->bytes());
  if (bytes > largest_factor) {
    return {StatusCode::too_large, "factor", -1, bytes, largest_factor};
  }
  const Progress factorising = [this](double fraction) { progress_("factorising", fraction); };
  return status(fast_->factorise(step, factorising));
}

void System::reorder_pins(const TimeStep& step) {
  std::visit(
      [&](auto& precomputation) {
        matrix_from_triplets(static_cast<int>(step.pinned.size()), static_cast<int>(step.m.size()),
                             selection_matrix(step.pinned), precomputation.C);
      },
      precomputation_);
}

double System::factor_bytes() const {
  if (fast_) return static_cast<double>(fast_->bytes());
  return std::visit([](const auto& precomputation) { return precomputation.Q.bytes(); },
                    precomputation_);
}

Status System::check(Method method, const TimeStep& step) const {
  if (method != Method::newton && method != Method::linearly_implicit) return {};
  // H has a 3 by 3 block for every entry of Q, and so has, nearly, its factor. Its pattern is first
  // a list, 18 entries to a spring, which is then sorted into another.
  const double bytes = 10 * factor_bytes() +
                       2.0 * 18 * sizeof(Triplets::value_type) * static_cast<double>(step.E.rows());
  if (bytes <= largest_newton_factor) return {};
  return {StatusCode::too_large, method_names()[static_cast<int>(method)], -1, bytes,
          largest_newton_factor};
}

void System::begin(const TimeStep& step, Workspace& workspace) {
  if (fast_) {
    fast_->begin(step);
  } else {
    inertial_right_hand_side(step, workspace.y);
  }
}

void System::inertial_right_hand_side(const TimeStep& step, Points& y) const {
  std::visit(
      [&](const auto& precomputation) {
        mass_spring::inertial_right_hand_side(step, precomputation.M, precomputation.C, y);
      },
      precomputation_);
}

namespace {

template <typename Problem>
std::unique_ptr<Minimiser> minimiser_on(Method method, const Problem& problem) {
  switch (method) {
    case Method::chebyshev:
      return std::make_unique<MinimiserOn<Chebyshev<Problem>, Problem>>(problem);
    case Method::anderson:
      return std::make_unique<MinimiserOn<Anderson<Problem>, Problem>>(problem);
    case Method::lbfgs:
      return std::make_unique<MinimiserOn<Lbfgs<Problem>, Problem>>(problem);
    default:
      return std::make_unique<MinimiserOn<LocalGlobal<Problem>, Problem>>(problem);
  }
}

}  // namespace

std::unique_ptr<Minimiser> System::minimiser(Method method, const TimeStep& step) {
  switch (method) {
    case Method::linearly_implicit:
      return std::make_unique<SingleStepBy<LinearlyImplicitEuler>>(step);
    case Method::symplectic_euler:
      return std::make_unique<SingleStepBy<SymplecticEuler>>(step);
    case Method::forward_euler:
      return std::make_unique<SingleStepBy<ForwardEuler>>(step);
    default:
      break;
  }
  if (method == Method::newton) {
    return std::make_unique<MinimiserOn<Newton, NewtonProblem>>(
        NewtonProblem(step, fast_ ? Pins::held : Pins::penalised));
  }
  if (fast_) return minimiser_on(method, FastProblem(*fast_));
  return std::visit(
      [&](const auto& precomputation) {
        return minimiser_on(method, PlainProblem(step, precomputation));
      },
      precomputation_);
}

void System::global_step(const TimeStep& step, Workspace& workspace, Iterate& iterate) {
  if (fast_) {
    WidePoints rows = fast_->rows_from_points(iterate.p_before);
    fast_->iterate(rows, 1);
    fast_->points_from_rows(rows, iterate.p);
    return;
  }
  std::visit(
      [&](const auto& precomputation) {
        mass_spring::global_step(precomputation, step.k, iterate.d, workspace, iterate.p);
      },
      precomputation_);
}

void System::fast_mass_springs_step(const TimeStep& step, Workspace& workspace, Iterate& iterate,
                                    int iterations) {
  if (fast_) {
    WidePoints rows = fast_->rows_from_points(step.p_curr);
    fast_->iterate(rows, iterations - 1);
    fast_->points_from_rows(rows, iterate.p_before);
    local_step(step.E, step.r, iterate.p_before, iterate.d);
    fast_->iterate(rows, 1);
    fast_->points_from_rows(rows, iterate.p);
  } else if (const auto* dense = std::get_if<DensePrecomputation>(&precomputation_)) {
    fast_mass_springs_step_dense(step, *dense, workspace, iterate, iterations);
  } else {
    fast_mass_springs_step_sparse(step, std::get<SparsePrecomputation>(precomputation_), workspace,
                                  iterate, iterations);
  }
}

void System::rehearse_local_step(const TimeStep& step, int times) const {
  if (fast_) {
    WidePoints g;  // #V rows, N
    const WidePoints p = fast_->rows_from_points(step.p_curr);
    for (int i = 0; i < times; ++i) fast_->gradient(p, g);
  } else {
    Points d;  // #E by 3, m
    for (int i = 0; i < times; ++i) local_step(step.E, step.r, step.p_curr, d);
  }
}

void System::rehearse_global_step(const TimeStep& step, int times) {
  if (fast_) {
    const WidePoints g = fast_->rows_from_points(step.f_ext);
    WidePoints x;  // #V rows, m
    for (int i = 0; i < times; ++i) {
      x = g;
      fast_->apply_inverse(x);
    }
    return;
  }
  Workspace workspace;
  Points d, p;  // #E by 3 and #V by 3, m
  local_step(step.E, step.r, step.p_curr, d);
  inertial_right_hand_side(step, workspace.y);
  std::visit(
      [&](const auto& precomputation) {
        for (int i = 0; i < times; ++i) {
          mass_spring::global_step(precomputation, step.k, d, workspace, p);
        }
      },
      precomputation_);
}

double System::residual(const TimeStep& step, const Iterate& iterate, Workspace& workspace) const {
  Points Qp;  // #V by 3, N
  std::visit(
      [&](const auto& precomputation) {
        right_hand_side(precomputation.A, step.k, iterate.d, workspace);
        system_product(step, precomputation, iterate.p, Qp);
      },
      precomputation_);
  Vector missed = (Qp - workspace.b).rowwise().lpNorm<Eigen::Infinity>();  // #V, N
  if (fast_) {
    for (const int pinned : step.pinned) missed(pinned) = 0;
  }
  return missed.maxCoeff();
}

VertexProbe System::probe(const TimeStep& step, const Iterate& iterate, const Points& y,
                          int i) const {
  return std::visit(
      [&](const auto& precomputation) { return vertex_probe(step, precomputation, iterate, y, i); },
      precomputation_);
}

std::vector<int> System::order() const {
  if (fast_) return fast_->order();
  return std::visit([](const auto& precomputation) { return precomputation.Q.order(); },
                    precomputation_);
}

Triplets System::A() const {
  return std::visit([](const auto& matrices) { return triplets_from_matrix(matrices.A); },
                    precomputation_);
}

Triplets System::M() const {
  return std::visit([](const auto& matrices) { return triplets_from_matrix(matrices.M); },
                    precomputation_);
}

Triplets System::C() const {
  return std::visit([](const auto& matrices) { return triplets_from_matrix(matrices.C); },
                    precomputation_);
}

}  // namespace mass_spring
