#include "forward_kinematics.h"

namespace kinematics {

template <typename Scalar>
void forward_kinematics(const Chain<Scalar>& chain, int start, Pose<Scalar>& pose) {
  for (int i = start; i < chain.joints(); ++i) {
    if (i == 0) {
      pose.x[0] = chain.root;
      pose.R[0] = pose.q[0];
    } else {
      pose.x[i] = pose.x[i - 1] + pose.R[i - 1] * chain.offsets[i - 1];
      pose.R[i] = pose.R[i - 1] * pose.q[i];
    }
  }
}

template <typename Scalar>
Pose<Scalar> rest_pose(const Chain<Scalar>& chain) {
  Pose<Scalar> pose;
  pose.q.assign(chain.joints(), Eigen::Quaternion<Scalar>::Identity());
  pose.R.resize(chain.joints());
  pose.x.resize(chain.joints());
  forward_kinematics(chain, 0, pose);
  return pose;
}

template void forward_kinematics(const Chain<double>&, int, Pose<double>&);
template void forward_kinematics(const Chain<float>&, int, Pose<float>&);
template Pose<double> rest_pose(const Chain<double>&);
template Pose<float> rest_pose(const Chain<float>&);

}  // namespace kinematics
