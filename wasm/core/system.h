#pragma once

#include <variant>

#include "parameters.h"
#include "precomputation.h"
#include "time_step.h"
#include "vertex_probe.h"

namespace mass_spring {

/// The precomputation in whichever storage was asked for, and what is done with it.
class System {
 public:
  /// Gives back the memory of the last system, of which there may not be twice as much.
  void clear(Storage storage);

  /// Matrices and factor for this time step and those that differ in forces, targets or positions
  /// only.
  /// @param V  #V by 3, m: rest positions
  /// @param r  #E, m: rest lengths (result)
  /// @return whether Q is positive definite as far as the arithmetic can tell
  bool precompute(const Points& V, const TimeStep& step, Vector& r);

  /// Makes C anew, and nothing else: for the same set of pins in another order.
  void reorder_pins(const TimeStep& step);

  void inertial_right_hand_side(const TimeStep& step, Points& y) const;
  void global_step(double k, const Points& d, Workspace& workspace, Points& p) const;
  void fast_mass_springs_step(const TimeStep& step, Workspace& workspace, Iterate& iterate,
                              int iterations) const;

  /// max |Qp - b|, N.
  double residual(const TimeStep& step, const Points& p, const Points& b) const;
  VertexProbe probe(const TimeStep& step, const Iterate& iterate, const Points& y, int i) const;
  Triplets A() const;
  Triplets M() const;
  Triplets C() const;

 private:
  std::variant<SparsePrecomputation, DensePrecomputation> precomputation_;
};

}  // namespace mass_spring
