#include "inverse_kinematics.h"

#include <cmath>

#include "forward_kinematics.h"
#include "inverse_kinematics_ccd.h"
#include "inverse_kinematics_fabrik.h"
#include "inverse_kinematics_least_squares.h"
#include "rotations_from_positions.h"
#include "validate_points.h"

namespace kinematics {

using mass_spring::Status;
using mass_spring::StatusCode;
using mass_spring::validate_points;

const std::vector<std::string>& method_names() {
  static const std::vector<std::string> names = {"ccd", "fabrik", "least-squares"};
  return names;
}

namespace {

Eigen::Vector3d row(const std::vector<double>& points, int i) {
  return Eigen::Map<const Eigen::Vector3d>(points.data() + 3 * i);
}

Status validate_settings(const Settings& settings) {
  if (settings.iterations < 1) {
    return {StatusCode::not_positive, "iterations", -1, static_cast<double>(settings.iterations)};
  }
  if (!std::isfinite(settings.epsilon)) {
    return {StatusCode::not_finite, "epsilon", -1, settings.epsilon};
  }
  if (settings.epsilon <= 0) return {StatusCode::not_positive, "epsilon", -1, settings.epsilon};
  if (!std::isfinite(settings.turn_limit)) {
    return {StatusCode::not_finite, "turn_limit", -1, settings.turn_limit};
  }
  if (settings.turn_limit <= 0) {
    return {StatusCode::not_positive, "turn_limit", -1, settings.turn_limit};
  }
  return {};
}

Status validate_bend_limits(const std::vector<double>& limits, int links) {
  const int count = static_cast<int>(limits.size());
  if (count != 0 && count != links) {
    return {StatusCode::wrong_length, "bend_limits", -1, static_cast<double>(count)};
  }
  for (int i = 0; i < count; ++i) {
    if (!std::isfinite(limits[i])) return {StatusCode::not_finite, "bend_limits", i, limits[i]};
    if (limits[i] < 0) return {StatusCode::negative, "bend_limits", i, limits[i]};
  }
  return {};
}

Eigen::Quaterniond rotation(const std::vector<double>& q, int i) {
  return Eigen::Quaterniond(Eigen::Map<const Eigen::Vector4d>(q.data() + 4 * i));
}

Status validate_rotations(const std::vector<double>& q, int joints) {
  const int count = static_cast<int>(q.size());
  if (count != 0 && count != 4 * joints) {
    return {StatusCode::wrong_length, "start_q", -1, static_cast<double>(count)};
  }
  for (int i = 0; i < count / 4; ++i) {
    const double norm = rotation(q, i).norm();
    if (!std::isfinite(norm)) return {StatusCode::not_finite, "start_q", i, norm};
    if (norm == 0) return {StatusCode::not_positive, "start_q", i, norm};
  }
  return {};
}

/// None may be without length, as the precision of the search has it.
template <typename Vector3>
Status validate_links(const std::string& field, const std::vector<Vector3>& links) {
  for (std::size_t i = 0; i < links.size(); ++i) {
    const double length = links[i].norm();
    if (!(length > 0)) return {StatusCode::not_positive, field, static_cast<int>(i), length};
  }
  return {};
}

template <typename Scalar>
Status validate(const Task& task) {
  const int links = static_cast<int>(task.offsets.size() / 3);
  const int given = task.start.empty() || !task.start_q.empty() ? 0 : links + 1;
  for (const Status& status :
       {links > 0 ? Status{} : Status{StatusCode::wrong_length, "links", -1, 0},
        validate_points("links", task.offsets, links), validate_points("root", task.root, 1),
        validate_points("target", task.target, 1), validate_points("start", task.start, given),
        validate_rotations(task.start_q, links + 1), validate_settings(task.settings),
        validate_bend_limits(task.settings.bend_limits, links)}) {
    if (!status.ok()) return status;
  }
  const auto point = [](const std::vector<double>& points, int i) {
    return typename Chain<Scalar>::Vector3(row(points, i).template cast<Scalar>());
  };
  std::vector<typename Chain<Scalar>::Vector3> offsets, starts;
  for (int i = 0; i < links; ++i) offsets.push_back(point(task.offsets, i));
  for (int i = 0; i + 1 < given; ++i) {
    starts.push_back(point(task.start, i + 1) - point(task.start, i));
  }
  for (const Status& status : {validate_links("links", offsets), validate_links("start", starts)}) {
    if (!status.ok()) return status;
  }
  if ((point(task.target, 0) - point(task.root, 0)).norm() == 0) {
    return {StatusCode::on_root, "target", -1, 0};
  }
  return {};
}

template <typename Scalar>
Answer solve(const Task& task) {
  using Vector3 = typename Chain<Scalar>::Vector3;
  Chain<Scalar> chain;
  chain.root = row(task.root, 0).cast<Scalar>();
  for (std::size_t i = 0; i < task.offsets.size() / 3; ++i) {
    chain.offsets.push_back(row(task.offsets, i).cast<Scalar>());
  }
  Pose<Scalar> start = rest_pose(chain);
  if (!task.start.empty()) {
    std::vector<Vector3> x;
    for (int i = 0; i < chain.joints(); ++i) x.push_back(row(task.start, i).cast<Scalar>());
    rotations_from_positions(chain, x, start);
  }
  if (!task.start_q.empty()) {
    for (int i = 0; i < chain.joints(); ++i) {
      start.q[i] = rotation(task.start_q, i).normalized().template cast<Scalar>();
    }
    forward_kinematics(chain, 0, start);
  }
  const Vector3 target = row(task.target, 0).cast<Scalar>();
  const auto method = task.method == Method::ccd      ? inverse_kinematics_ccd<Scalar>
                      : task.method == Method::fabrik ? inverse_kinematics_fabrik<Scalar>
                                                      : inverse_kinematics_least_squares<Scalar>;
  const Solution<Scalar> solution = method(chain, start, target, task.settings);

  Answer answer;
  const auto add = [](std::vector<double>& list, const auto& values) {
    for (const Scalar value : values) list.push_back(value);
  };
  answer.outcome = solution.outcome;
  answer.iterations = solution.iterations;
  answer.error = (solution.pose.effector() - target).norm();
  for (const auto& x : solution.start.x) add(answer.start_x, x);
  for (const auto& q : solution.start.q) add(answer.start_q, q.coeffs());
  for (const auto& x : solution.pose.x) add(answer.x, x);
  for (const auto& q : solution.pose.q) add(answer.q, q.coeffs());
  add(answer.errors, solution.errors);
  for (const auto& event : solution.events) {
    answer.events.insert(answer.events.end(),
                         {event.iteration, static_cast<int>(event.kind), event.joint});
    for (const auto& x : event.x) add(answer.event_x, x);
    for (const auto& q : event.q) add(answer.event_q, q.coeffs());
  }
  return answer;
}

template <typename Scalar>
Status validate_and_solve(const Task& task, Answer& answer) {
  const Status status = validate<Scalar>(task);
  if (status.ok()) answer = solve<Scalar>(task);
  return status;
}

}  // namespace

Status inverse_kinematics(const Task& task, Answer& answer) {
  return task.single_precision ? validate_and_solve<float>(task, answer)
                               : validate_and_solve<double>(task, answer);
}

}  // namespace kinematics
