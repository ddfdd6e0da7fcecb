#include "trace.h"

#include <algorithm>
#include <cmath>

#include "edge_vectors.h"
#include "gradient.h"
#include "largest_free_component.h"
#include "local_step.h"
#include "objective.h"
#include "projection_energy.h"

namespace mass_spring {

// Where all iterates would take more bytes, only every second, third, … is kept; the others are
// computed again.
constexpr double most_bytes = 32 << 20;

void Trace::append(const TimeStep& step, const Cursor& cursor, double residual, int iterations) {
  const Points& p = cursor.iterate.p;
  const Objective E = objective(step, p);
  // At predict nothing is projected yet, and the surrogate is the objective itself.
  const double spring_term =
      cursor.half_step == 0 ? E.potential : projection_energy(step.E, step.k, cursor.iterate.d, p);
  const double surrogate = E.objective - E.potential + spring_term;
  // Only the global step moves vertices; elsewhere p_before depends on where the cursor set out.
  const double change =
      cursor.at_global() ? (p - cursor.iterate.p_before).rowwise().norm().maxCoeff() : 0;
  Points g;  // #V by 3, N
  gradient(step, p, g);
  rows_.insert(rows_.end(), {static_cast<double>(cursor.half_step), E.objective, surrogate,
                             E.potential, E.inertia, E.external, E.pin,
                             largest_free_component(g, step.pinned), residual, change});

  if (cursor.half_step == 0) {
    const double bytes = sizeof(double) * static_cast<double>(p.size()) * iterations;
    stride_ = static_cast<int>(std::ceil(bytes / most_bytes));
  }
  const int next_kept = 2 * stride_ * static_cast<int>(iterates_.size());
  if (cursor.half_step == next_kept) iterates_.push_back(p);
}

Cursor Trace::start_for(int half_step, const TimeStep& step) const {
  Cursor cursor;
  Iterate& iterate = cursor.iterate;
  if (iterates_.empty()) {
    iterate.p = iterate.p_before = step.p_curr;
    edge_vectors(step.E, iterate.p, iterate.d);
    return cursor;
  }
  const int recorded_half_step = std::min(half_step, recorded() - 1);
  const int iteration = recorded_half_step / 2;  // how many global steps lie before
  if (stride_ == 1) {
    cursor.half_step = recorded_half_step;
    iterate.p = iterates_[iteration];
    iterate.p_before = iterates_[std::max(iteration - 1, 0)];
  } else {
    const int last =
        std::min(std::max(iteration - 1, 0) / stride_, static_cast<int>(iterates_.size()) - 1);
    cursor.half_step = 2 * stride_ * last;
    iterate.p = iterate.p_before = iterates_[last];
  }
  if (cursor.half_step == 0) {
    edge_vectors(step.E, iterate.p, iterate.d);
  } else {
    local_step(step.E, step.r, cursor.half_step % 2 == 1 ? iterate.p : iterate.p_before, iterate.d);
  }
  return cursor;
}

}  // namespace mass_spring
