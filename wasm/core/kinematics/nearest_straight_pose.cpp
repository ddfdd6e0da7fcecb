#include "nearest_straight_pose.h"

#include <algorithm>
#include <numeric>

namespace kinematics {

template <typename Scalar>
std::optional<std::vector<typename Chain<Scalar>::Vector3>> nearest_straight_pose(
    const Chain<Scalar>& chain, const typename Chain<Scalar>::Vector3& target) {
  std::vector<Scalar> lengths;  // m
  for (const auto& offset : chain.offsets) lengths.push_back(offset.norm());
  const auto longest = std::max_element(lengths.begin(), lengths.end());
  const Scalar farthest = std::accumulate(lengths.begin(), lengths.end(), Scalar(0));
  const Scalar nearest = 2 * *longest - farthest;
  const Scalar distance = (target - chain.root).norm();
  const bool too_far = distance > farthest, too_near = distance < nearest;
  if (!too_far && !too_near) return {};
  const typename Chain<Scalar>::Vector3 towards = (target - chain.root) / distance;
  std::vector<typename Chain<Scalar>::Vector3> x = {chain.root};
  for (auto length = lengths.begin(); length != lengths.end(); ++length) {
    const bool away = too_near && length != longest;
    x.push_back(x.back() + (away ? -*length : *length) * towards);
  }
  return x;
}

template std::optional<std::vector<Eigen::Vector3d>> nearest_straight_pose(const Chain<double>&,
                                                                           const Eigen::Vector3d&);
template std::optional<std::vector<Eigen::Vector3f>> nearest_straight_pose(const Chain<float>&,
                                                                           const Eigen::Vector3f&);

}  // namespace kinematics
