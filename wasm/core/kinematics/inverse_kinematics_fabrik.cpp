#include "inverse_kinematics_fabrik.h"

#include "search.h"

namespace kinematics {

namespace {

/// Holds every joint to its limits, from the root on: each points its link from where it really is
/// to where the next joint was to be, and so makes up for what those before it may not do.
template <typename Scalar>
void hold_towards(const Chain<Scalar>& chain, const std::vector<typename Chain<Scalar>::Vector3>& x,
                  const JointLimits<Scalar>& limits, Pose<Scalar>& pose) {
  using Quaternion = typename Pose<Scalar>::Quaternion;
  for (int i = 0; i + 1 < chain.joints(); ++i) {
    const Quaternion before = i == 0 ? Quaternion::Identity() : pose.R[i - 1];
    const Quaternion R = before * pose.q[i];
    const auto turn = Quaternion::FromTwoVectors(R * chain.offsets[i], x[i + 1] - pose.x[i]);
    pose.q[i] = limits.hold(i, before.conjugate() * turn * R);
    forward_kinematics(chain, i, pose);
  }
}

}  // namespace

template <typename Scalar>
Solution<Scalar> inverse_kinematics_fabrik(const Chain<Scalar>& chain, const Pose<Scalar>& start,
                                           const typename Chain<Scalar>::Vector3& target,
                                           const Settings& settings) {
  using Vector3 = typename Chain<Scalar>::Vector3;
  const JointLimits<Scalar> limits(chain, start, settings);
  return search(chain, start, target, settings, limits,
                [&](Pose<Scalar>& pose, int iteration, auto& events) {
                  std::vector<Vector3> x = pose.x;
                  const int last = chain.joints() - 1;
                  // The joint `moved` goes to where it is as far from `from` as their link is long.
                  const auto pull = [&](int from, int moved, int link) {
                    const Vector3 apart = x[moved] - x[from];
                    const Scalar length = chain.offsets[link].norm(), distance = apart.norm();
                    x[moved] = x[from] + (distance > 0 ? (length / distance * apart).eval()
                                                       : (length * Vector3::UnitX()).eval());
                  };
                  x[last] = target;
                  for (int i = last - 1; i >= 0; --i) pull(i + 1, i, i);
                  events.push_back({iteration, Event<Scalar>::Kind::backward, -1, x, pose.q});
                  x[0] = chain.root;
                  for (int i = 0; i < last; ++i) pull(i, i + 1, i);
                  rotations_from_positions(chain, x, pose);
                  events.push_back({iteration, Event<Scalar>::Kind::forward, -1, x, pose.q});
                  if (limits.any()) {
                    hold_towards(chain, x, limits, pose);
                    events.push_back({iteration, Event<Scalar>::Kind::limit, -1, pose.x, pose.q});
                  }
                });
}

template Solution<double> inverse_kinematics_fabrik(const Chain<double>&, const Pose<double>&,
                                                    const Eigen::Vector3d&, const Settings&);
template Solution<float> inverse_kinematics_fabrik(const Chain<float>&, const Pose<float>&,
                                                   const Eigen::Vector3f&, const Settings&);

}  // namespace kinematics
