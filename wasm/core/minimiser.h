#pragma once

#include "types.h"

namespace mass_spring {

/// A method at work on one time step, whatever the method and the path.
class Minimiser {
 public:
  virtual ~Minimiser() = default;

  /// @param p  #V by 3, m: where to start; on the fast path pinned vertices go to where they are
  /// held
  void begin(const Points& p) {
    iterations_ = 0;
    start(p);
  }

  /// @return whether p changed; if not, E cannot be lowered by more than its rounding
  bool iterate() {
    ++iterations_;
    return advance();
  }

  /// Since begin().
  int iterations() const { return iterations_; }

  /// J: E(p) - objective_offset().
  virtual double objective() const = 0;
  /// J: what is the same for all p of the time step and left out of objective(), so that small
  /// decreases are not rounded away.
  virtual double objective_offset() const = 0;
  /// N: ‖∂E/∂p‖∞ of the vertices that are not pinned.
  virtual double gradient_norm() const = 0;
  /// @param p         #V by 3, m (result)
  virtual void positions(Points& p) const = 0;

 private:
  virtual void start(const Points& p) = 0;
  virtual bool advance() = 0;

  int iterations_ = 0;
};

}  // namespace mass_spring
