#pragma once

#include "solution.h"

namespace kinematics {

/// Damped least squares: all joints turn at once by Δθ = Jᵀ(J Jᵀ + λ²I)⁻¹(target - effector), J
/// being how the effector moves with the joints' turns; λ² is the square of the distance that is
/// left, times a power of two: halved after every iteration, raised by fours until one comes
/// nearer. Levenberg and Marquardt; Buss, "Introduction to Inverse Kinematics" (2004), section 6
/// @param start   the pose to begin with
/// @param target  m
template <typename Scalar>
Solution<Scalar> inverse_kinematics_least_squares(const Chain<Scalar>& chain,
                                                  const Pose<Scalar>& start,
                                                  const typename Chain<Scalar>::Vector3& target,
                                                  const Settings& settings);

}  // namespace kinematics
