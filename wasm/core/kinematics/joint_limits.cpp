#include "joint_limits.h"

#include <cmath>

#include "forward_kinematics.h"

namespace kinematics {

template <typename Scalar>
JointLimits<Scalar>::JointLimits(const Chain<Scalar>& chain, const Pose<Scalar>& start,
                                 const Settings& settings)
    : chain_(chain),
      start_(start.q),
      bend_limits_(settings.bend_limits),
      turn_limit_(settings.turn_limit) {}

template <typename Scalar>
typename JointLimits<Scalar>::Quaternion JointLimits<Scalar>::hold(int i,
                                                                   const Quaternion& q) const {
  using Vector3 = typename Chain<Scalar>::Vector3;
  Quaternion held = q;
  if (turning()) {
    const Scalar turned = start_[i].angularDistance(q), most = Scalar(turn_limit_);
    if (turned > most) held = start_[i].slerp(most / turned, q);
  }
  if (bending()) {
    const Vector3 rest = chain_.offsets[i], link = held * rest;
    const Vector3 across = rest.cross(link);
    const Scalar bent = std::atan2(across.norm(), rest.dot(link)), most = Scalar(bend_limits_[i]);
    if (bent > most) {
      // Where the link points straight back, any axis across it brings it nearer.
      const Vector3 axis = across.norm() > 0 ? across.normalized() : rest.unitOrthogonal();
      held = Eigen::AngleAxis<Scalar>(most - bent, axis) * held;
    }
  }
  return held.normalized();
}

template <typename Scalar>
void JointLimits<Scalar>::hold(Pose<Scalar>& pose) const {
  for (int i = 0; i + 1 < chain_.joints(); ++i) pose.q[i] = hold(i, pose.q[i]);
  forward_kinematics(chain_, 0, pose);
}

template class JointLimits<double>;
template class JointLimits<float>;

}  // namespace kinematics
