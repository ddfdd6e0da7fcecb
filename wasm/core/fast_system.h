#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "block_solver.h"
#include "elastic_gradient.h"
#include "symbolic_cholesky.h"
#include "time_step.h"
#include "types.h"
#include "wide_point.h"

namespace mass_spring {

/// The time step of fast_mass_springs_step, arranged for speed. Three things differ:
///  - pinned vertices are exactly where they are held and no unknowns, so w does not occur and Q is
///    that of the free vertices;
///  - positions are kept in rows of their own: the free vertices in the order of elimination, then
///    the pinned ones;
///  - the iteration reads p ← p - Q⁻¹∇E(p), which is Q p = b without the cancellation.
/// Calls in this order, each as often as what it is given changes: analyse, factorise, begin; then
/// the rest. Equal input gives equal bits, on every machine.
class FastSystem {
 public:
  /// Orders the vertices and finds the pattern of L.
  /// @param V       #V by 3, m: rest positions
  /// @param E       #E by 2
  /// @param r       #E, m: rest lengths
  /// @param pinned  #pinned
  void analyse(const Points& V, const Edges& E, const Vector& r, const Indices& pinned);

  /// What keeping L takes, in doubles and in floats: known after analyse(), before any of it is
  /// computed or allocated.
  std::int64_t bytes() const {
    return pattern_.values * std::int64_t{sizeof(double) + sizeof(float)};
  }

  /// Which of the free vertices is eliminated first, second, …: known after analyse().
  std::vector<int> order() const;

  /// @param step  its stiffness, masses, Δt, damping, and which vertices are pulled
  /// @return whether Q is positive definite as far as the arithmetic can tell; if not, there is no
  /// factor until the next call
  bool factorise(const TimeStep& step, const Progress& progress);

  /// Takes the known positions, forces and targets of a time step; its other fields must be those
  /// of analyse() and factorise(), but that its pins may be listed in another order.
  void begin(const TimeStep& step);

  /// @param p  #V by 3, m (or anything else of three numbers a vertex)
  WidePoints rows_from_points(const Points& p) const;
  /// @param rows  #V
  /// @param p     #V by 3 (result)
  void points_from_rows(const WidePoints& rows, Points& p) const;

  /// Moves the pinned vertices of p to their targets.
  void hold_pins(WidePoints& p) const;

  /// @param p  #V rows, m
  /// @param g  #V rows, N: ∂E/∂p, 0 in rows of pinned vertices (result)
  /// @return  E(p) - objective_offset(), J
  double gradient(const WidePoints& p, WidePoints& g) const;

  /// J: what is the same for all p of the time step. Left out of E(p) so that small decreases
  /// are not rounded away; its sum with gradient() is objective() at p.
  double objective_offset() const { return objective_offset_; }

  /// g ← Q⁻¹g; the rows of pinned vertices stay as they are.
  void apply_inverse(WidePoints& g);
  /// The same in floats, in three quarters of the time: for directions, in which a relative error
  /// of 1e-7 times the condition number of Q does no harm.
  void apply_inverse(RoughPoints& g);

  /// Local and global step in turn, `iterations` times, without dashpots and pulls. Pinned vertices
  /// may start anywhere: as in fast_mass_springs_step the first global step puts them where they
  /// are held.
  void iterate(WidePoints& p, int iterations);

 private:
  /// A row that is drawn towards a point.
  struct Drawn {
    int row;
    WidePoint target;  // m
  };
  /// The dashpot beside a spring.
  struct Dashpot {
    RowSprings::Ends ends;
    WidePoint n;    // direction of the spring at p^t
    double length;  // m: nᵀ(p^t_i - p^t_j)
  };

  double add_dashpot_gradient(const WidePoints& p, WidePoints& g) const;
  double add_pull_gradient(const WidePoints& p, WidePoints& g) const;

  std::vector<int> row_;                          // #V: the row of every vertex
  int free_count_ = 0;                            // rows of free vertices
  RowSprings springs_;                            // sorted by rows
  std::vector<std::array<int, 2>> held_springs_;  // rows of a free and a pinned vertex
  SymbolicCholesky pattern_;
  BlockSolver solver_;
  double k_ = 0;           // N/m
  double coupling_ = 0;    // N/m: what Q has off its diagonal, its sign turned
  double resistance_ = 0;  // N/m: c/Δt
  std::vector<Dashpot> dashpots_;
  double pull_k_ = 0;  // N/m
  std::vector<Drawn> drawn_;
  Vector inertia_;               // #V, by rows, N/m: m/Δt², 0 for pinned vertices
  WidePoints inertial_;          // #V rows, m: where vertices go without springs, or are held
  double objective_offset_ = 0;  // J
  WidePoints g_;                 // #V rows, N: scratch
};

}  // namespace mass_spring
