#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "fast_system.h"
#include "minimiser.h"
#include "parameters.h"
#include "precomputation.h"
#include "status.h"
#include "time_step.h"
#include "vertex_probe.h"

namespace mass_spring {

/// Told which stage precompute() is at, as module.ts names it, and which fraction of that is done.
using StageProgress = std::function<void(const std::string& stage, double fraction)>;

/// The precomputation in whichever storage was asked for, and what is done with it. On the fast
/// path the matrices are there to be looked at, and FastSystem does the work.
class System {
 public:
  void set_progress(StageProgress progress) { progress_ = std::move(progress); }

  /// Gives back the memory of the last system, of which there may not be twice as much.
  void clear(const Parameters& parameters);

  /// Matrices and factor for this time step and those that differ in forces, targets or positions
  /// only.
  /// @param V  #V by 3, m: rest positions
  /// @param r  #E, m: rest lengths (result)
  /// @return factorisation_failed where Q is not positive definite as far as the arithmetic can
  /// tell; too_large, before any work, where its factor would not fit the memory
  Status precompute(const Points& V, const TimeStep& step, Vector& r);

  /// Makes C anew, and nothing else: for the same set of pins in another order.
  void reorder_pins(const TimeStep& step);

  /// too_large where the method would not fit the memory beside the factor of Q.
  Status check(Method method, const TimeStep& step) const;

  /// What no iteration of this time step changes.
  void begin(const TimeStep& step, Workspace& workspace);

  /// y, #V by 3, N. On the plain path begin() has done this; the fast path has no use for it.
  void inertial_right_hand_side(const TimeStep& step, Points& y) const;

  /// A method at work on `step`, which has to stay where it is, as has this system; both may change
  /// between its time steps, but not by clear() or precompute().
  std::unique_ptr<Minimiser> minimiser(Method method, const TimeStep& step);

  /// From p_before and d to p.
  void global_step(const TimeStep& step, Workspace& workspace, Iterate& iterate);
  void fast_mass_springs_step(const TimeStep& step, Workspace& workspace, Iterate& iterate,
                              int iterations);

  /// The halves of an iteration from p^t, to be timed; on the fast path, ∂E/∂p and Q⁻¹.
  void rehearse_local_step(const TimeStep& step, int times) const;
  void rehearse_global_step(const TimeStep& step, int times);

  /// max |Qp - b|, N, b = k Aᵀd + y, over the equations that the global step solves: on the fast
  /// path those of the vertices that are not pinned.
  /// @param workspace  reads y; leaves b
  double residual(const TimeStep& step, const Iterate& iterate, Workspace& workspace) const;
  VertexProbe probe(const TimeStep& step, const Iterate& iterate, const Points& y, int i) const;
  /// Which unknown of Q p = b, a vertex, is eliminated first, second, …; on the fast path pinned
  /// vertices are none.
  std::vector<int> order() const;
  Triplets A() const;
  Triplets M() const;
  Triplets C() const;

 private:
  double factor_bytes() const;

  StageProgress progress_ = [](const std::string&, double) {};
  std::variant<SparsePrecomputation, DensePrecomputation> precomputation_;
  std::optional<FastSystem> fast_;
  Indices analysed_pins_;  // #pinned: those that fast_ was analysed for
  bool analysed_ = false;
};

}  // namespace mass_spring
