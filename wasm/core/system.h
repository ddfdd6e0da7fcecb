#pragma once

#include <optional>
#include <variant>

#include "fast_system.h"
#include "parameters.h"
#include "precomputation.h"
#include "status.h"
#include "time_step.h"
#include "vertex_probe.h"

namespace mass_spring {

/// The precomputation in whichever storage was asked for, and what is done with it. On the fast
/// path the matrices are there to be looked at, and FastSystem does the work.
class System {
 public:
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

  /// What no iteration of this time step changes.
  void begin(const TimeStep& step, Workspace& workspace);

  /// From p_before and d to p.
  void global_step(const TimeStep& step, Workspace& workspace, Iterate& iterate);
  void fast_mass_springs_step(const TimeStep& step, Workspace& workspace, Iterate& iterate,
                              int iterations);

  /// max |Qp - b|, N, over the equations that the global step solves: on the fast path those of
  /// the vertices that are not pinned.
  double residual(const TimeStep& step, const Points& p, const Points& b) const;
  VertexProbe probe(const TimeStep& step, const Iterate& iterate, const Points& y, int i) const;
  Triplets A() const;
  Triplets M() const;
  Triplets C() const;

 private:
  std::variant<SparsePrecomputation, DensePrecomputation> precomputation_;
  std::optional<FastSystem> fast_;
  Indices analysed_pins_;  // #pinned: those that fast_ was analysed for
  bool analysed_ = false;
};

}  // namespace mass_spring
