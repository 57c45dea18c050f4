// SPDX-License-Identifier: Apache-2.0
#include "src/report/turning/turning_view.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace torquewright::report {
namespace {

using Eigen::Index;
using Eigen::Vector3d;

constexpr double kArrowShare = 0.6;    // of the robot's size: the greatest force
constexpr double kLongWay = 2.5;       // robot's sizes: the view goes along
constexpr double kLeastSize_m = 0.05;  // of a robot that is a point

struct Box {
  Vector3d least;
  Vector3d most;

  void include(const Vector3d& point) {
    least = least.cwiseMin(point);
    most = most.cwiseMax(point);
  }
  Vector3d size() const { return most - least; }
};

/// All that is drawn of a robot at an instant but its arrows: ends of its capsules.
void include_robot(const TurningView& view, const BodyPoses& poses, Index instant,
                   const Vector3d& from, Box& box) {
  for (std::size_t body = 0; body < view.shapes.size(); ++body) {
    const Vector3d place = poses.place_m(body, instant) - from;
    const Eigen::Matrix3d rotation = poses.rotation(body, instant);
    box.include(place);
    for (const DrawnCapsule& capsule : view.shapes[body].capsules) {
      box.include(place + rotation * capsule.to_m);
    }
  }
}

Vector3d force_at(const hopper::Series& series, const ForceColumns& columns, Index sample) {
  const auto at = [&](const std::string& header) {
    const Eigen::VectorXd* column = hopper::find_column(series, header);
    const double value = column == nullptr ? 0.0 : (*column)[sample];
    return std::isfinite(value) ? value : 0.0;
  };
  return {at(columns.x), at(columns.y), at(columns.z)};
}

void include_arrows(const ViewSource& source, Index instant, const TurningView& view,
                    const Vector3d& from, Box& box) {
  const Index sample = source.samples[static_cast<std::size_t>(instant)];
  for (std::size_t i = 0; i < view.forces.size(); ++i) {
    const Vector3d force_N = force_at(source.series, view.forces[i], sample);
    const double size_N = force_N.norm();
    if (!(size_N > 0.0)) continue;
    const dynamics::BodyPoint& point = source.robot.contacts[i].point;
    box.include(view.is.place_m(point.body, instant) +
                view.is.rotation(point.body, instant) * point.p_B_m - from +
                view.longest_m * source.scale.share(size_N) * force_N / size_N);
  }
}

Vector3d level(const Vector3d& point) { return {point.x(), point.y(), 0.0}; }

std::vector<std::vector<ToldValue>> told_of(const hopper::Robot& robot,
                                            const hopper::Series& series) {
  std::vector<std::vector<ToldValue>> told(robot.tree.bodies.size());
  for (std::size_t body = 1; body < told.size(); ++body) {
    const std::string& name = robot.tree.bodies[body].joint.name;
    for (const auto& [words, end, unit] : {std::tuple{"angle", "_position_rad", "rad"},
                                           {"way", "_position_m", "m"},
                                           {"joint torque", "_joint_torque_Nm", "Nm"},
                                           {"joint force", "_joint_force_N", "N"},
                                           {"drive torque", "_drive_torque_Nm", "Nm"}}) {
      if (hopper::find_column(series, name + end) == nullptr) continue;
      told[body].push_back({name + ": " + words, name + end, unit});
    }
  }
  return told;
}

void measure_robot(const ForceScale& scale, TurningView& view) {
  Box box{Vector3d::Zero(), Vector3d::Zero()};
  include_robot(view, view.is, 0, view.is.center_of_mass_m(0), box);
  view.size_m = std::max(box.size().norm(), kLeastSize_m);
  view.longest_m = scale.greatest_N > 0.0 ? kArrowShare * view.size_m : 0.0;
}

bool goes_far(const TurningView& view) {
  const Vector3d first = view.is.center_of_mass_m(0);
  Box way{first, first};
  for (Index i = 0; i < view.is.places_m.cols(); ++i) way.include(view.is.center_of_mass_m(i));
  return level(way.size()).norm() > kLongWay * view.size_m;
}

void frame(const ViewSource& source, TurningView& view) {
  measure_robot(source.scale, view);
  view.follows = goes_far(view);
  const Vector3d first = view.is.center_of_mass_m(0);
  const Vector3d begin = view.follows ? Vector3d(0.0, 0.0, first.z()) : first;
  Box box{begin, begin};
  for (Index i = 0; i < view.is.places_m.cols(); ++i) {
    const Vector3d from =
        view.follows ? level(view.is.center_of_mass_m(i)) : Vector3d(Vector3d::Zero());
    include_robot(view, view.is, i, from, box);
    include_arrows(source, i, view, from, box);
    if (view.planned && !view.follows) include_robot(view, *view.planned, i, from, box);
  }
  box.least.z() = std::min(box.least.z(), view.ground_m);
  view.radius_m = std::max(0.5 * box.size().norm(), kLeastSize_m);
  view.center_m = 0.5 * (box.least + box.most);
  if (view.follows) view.center_m.head<2>() = first.head<2>();
}

}  // namespace

TurningView turning_view(const ViewSource& source, const Eigen::MatrixXd& positions,
                         const Eigen::MatrixXd& planned) {
  TurningView view{body_shapes(source.robot), told_of(source.robot, source.series),
                   body_poses(source.robot, positions)};
  if (planned.cols() > 0) view.planned = body_poses(source.robot, planned);
  view.forces = source.forces;
  view.ground_m = source.ground_m;
  view.profile = source.profile;
  frame(source, view);
  return view;
}

double grid_m(const TurningView& view) {
  const double most_m = view.size_m / 3.0;
  const double power = std::pow(10.0, std::floor(std::log10(most_m)));
  for (const double factor : {5.0, 2.0}) {
    if (factor * power <= most_m) return factor * power;
  }
  return power;
}

}  // namespace torquewright::report
