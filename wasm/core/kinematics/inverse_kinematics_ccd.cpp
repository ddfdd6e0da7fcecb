#include "inverse_kinematics_ccd.h"

#include "rotation_between.h"
#include "search.h"

namespace kinematics {

template <typename Scalar>
Solution<Scalar> inverse_kinematics_ccd(const Chain<Scalar>& chain, const Pose<Scalar>& start,
                                        const typename Chain<Scalar>::Vector3& target,
                                        const Settings& settings) {
  using Vector3 = typename Chain<Scalar>::Vector3;
  const JointLimits<Scalar> limits(chain, start, settings);
  return search(chain, start, target, settings, limits,
                [&](Pose<Scalar>& pose, int iteration, auto& events) {
                  for (int i = chain.joints() - 2; i >= 0; --i) {
                    const auto to_own_frame = pose.R[i].conjugate();
                    const Vector3 ray = to_own_frame * (pose.effector() - pose.x[i]);
                    const Vector3 wanted = to_own_frame * (target - pose.x[i]);
                    pose.q[i] = limits.hold(i, pose.q[i] * rotation_between<Scalar>(ray, wanted));
                    forward_kinematics(chain, i, pose);
                    events.push_back({iteration, Event<Scalar>::Kind::joint, i, pose.x, pose.q});
                  }
                });
}

template Solution<double> inverse_kinematics_ccd(const Chain<double>&, const Pose<double>&,
                                                 const Eigen::Vector3d&, const Settings&);
template Solution<float> inverse_kinematics_ccd(const Chain<float>&, const Pose<float>&,
                                                const Eigen::Vector3f&, const Settings&);

}  // namespace kinematics
