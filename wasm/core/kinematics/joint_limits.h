#pragma once

#include <vector>

#include "chain.h"
#include "solution.h"

namespace kinematics {

/// How far the joints of a chain may turn during one search.
template <typename Scalar>
class JointLimits {
 public:
  using Quaternion = typename Pose<Scalar>::Quaternion;

  /// @param start  the pose that turning is counted from
  JointLimits(const Chain<Scalar>& chain, const Pose<Scalar>& start, const Settings& settings);

  bool any() const { return turning() || bending(); }
  bool bending() const { return !bend_limits_.empty(); }

  /// q, turned from the start by at most the turn limit, then bent by at most the joint's own.
  /// Where both cannot hold the bend limit does: the start itself was bent further, or bending back
  /// turns on, as it may under a turn limit of 15 degrees or more.
  Quaternion hold(int i, const Quaternion& q) const;

  /// Every joint, and forward kinematics.
  void hold(Pose<Scalar>& pose) const;

 private:
  bool turning() const { return turn_limit_ < no_limit; }

  const Chain<Scalar>& chain_;
  const std::vector<Quaternion> start_;
  const std::vector<double> bend_limits_;
  const double turn_limit_;
};

}  // namespace kinematics
