#include "inverse_kinematics_least_squares.h"

#include <Eigen/Cholesky>

#include "search.h"

namespace kinematics {

template <typename Scalar>
Solution<Scalar> inverse_kinematics_least_squares(const Chain<Scalar>& chain,
                                                  const Pose<Scalar>& start,
                                                  const typename Chain<Scalar>::Vector3& target,
                                                  const Settings& settings) {
  using Vector3 = typename Chain<Scalar>::Vector3;
  using Matrix3 = Eigen::Matrix<Scalar, 3, 3>;
  Scalar share = 1;  // of the squared distance: λ²
  const JointLimits<Scalar> limits(chain, start, settings);
  return search(
      chain, start, target, settings, limits, [&](Pose<Scalar>& pose, int iteration, auto& events) {
        const Vector3 missing = target - pose.effector();
        Matrix3 JJT = Matrix3::Zero();  // m²: Σ |r|²I - r rᵀ, r from each joint to the effector
        for (int i = 0; i + 1 < chain.joints(); ++i) {
          const Vector3 r = pose.effector() - pose.x[i];
          JJT += r.squaredNorm() * Matrix3::Identity() - r * r.transpose();
        }
        constexpr int most_attempts = 20;
        for (int attempt = 0; attempt < most_attempts; ++attempt) {
          const Scalar damping = share * missing.squaredNorm();                           // m²
          const Vector3 y = (JJT + damping * Matrix3::Identity()).ldlt().solve(missing);  // 1/m
          Pose<Scalar> next = pose;
          for (int i = 0; i + 1 < chain.joints(); ++i) {
            const Vector3 turn = (pose.effector() - pose.x[i]).cross(y);  // rad, in the world
            const Scalar angle = turn.norm();
            if (angle == 0) continue;
            const Vector3 axis = pose.R[i].conjugate() * (turn / angle);
            next.q[i] = limits.hold(i, pose.q[i] * Eigen::AngleAxis<Scalar>(angle, axis));
          }
          forward_kinematics(chain, 0, next);
          if ((next.effector() - target).norm() < missing.norm()) {
            pose = next;
            share /= 2;
            break;
          }
          share *= 4;
        }
        events.push_back({iteration, Event<Scalar>::Kind::all, -1, pose.x, pose.q});
      });
}

template Solution<double> inverse_kinematics_least_squares(const Chain<double>&,
                                                           const Pose<double>&,
                                                           const Eigen::Vector3d&, const Settings&);
template Solution<float> inverse_kinematics_least_squares(const Chain<float>&, const Pose<float>&,
                                                          const Eigen::Vector3f&, const Settings&);

}  // namespace kinematics
