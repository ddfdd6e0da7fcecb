#include "rotations_from_positions.h"

#include "forward_kinematics.h"

namespace kinematics {

template <typename Scalar>
void rotations_from_positions(const Chain<Scalar>& chain,
                              const std::vector<typename Chain<Scalar>::Vector3>& x,
                              Pose<Scalar>& pose) {
  using Quaternion = Eigen::Quaternion<Scalar>;
  using Vector3 = typename Chain<Scalar>::Vector3;
  Quaternion before = Quaternion::Identity();  // R_{i-1}
  for (int i = 0; i + 1 < chain.joints(); ++i) {
    const Quaternion R = before * pose.q[i];
    const Vector3 link = R * chain.offsets[i], wanted = x[i + 1] - x[i];
    const Quaternion turned = Quaternion::FromTwoVectors(link, wanted) * R;
    pose.q[i] = (before.conjugate() * turned).normalized();
    before = before * pose.q[i];
  }
  forward_kinematics(chain, 0, pose);
}

template void rotations_from_positions(const Chain<double>&, const std::vector<Eigen::Vector3d>&,
                                       Pose<double>&);
template void rotations_from_positions(const Chain<float>&, const std::vector<Eigen::Vector3f>&,
                                       Pose<float>&);

}  // namespace kinematics
