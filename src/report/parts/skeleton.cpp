// SPDX-License-Identifier: Apache-2.0
#include "src/report/parts/skeleton.hpp"

#include "dynamics/point.hpp"
#include "robot/model/robot_centroid.hpp"

namespace torquewright::report {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

Vector2d seen(const Vector3d& point) { return {point.x(), point.z()}; }

void add_body(const hopper::Robot& robot, std::size_t body, Skeleton& skeleton) {
  const auto& bodies = robot.tree.bodies;
  bool ends_here = true;
  for (std::size_t child = 1; child < bodies.size(); ++child) {
    if (bodies[child].parent != body) continue;
    ends_here = false;
    skeleton.bones.push_back({body, body, child});
  }
  std::vector<std::size_t> feet;
  for (std::size_t i = 0; i < robot.contacts.size(); ++i) {
    if (robot.contacts[i].point.body == body) feet.push_back(skeleton.contacts[i]);
  }
  for (std::size_t i = 0; i < feet.size(); ++i) {
    skeleton.bones.push_back({body, body, feet[i]});
    if (i > 0) skeleton.bones.push_back({body, feet[i - 1], feet[i]});
  }
  if ((ends_here && feet.empty()) || body == 0) {
    skeleton.points.push_back({body, bodies[body].inertia.center_of_mass_m});
    skeleton.bones.push_back({body, body, skeleton.points.size() - 1});
  }
}

}  // namespace

Skeleton skeleton_of(const hopper::Robot& robot) {
  Skeleton skeleton;
  for (std::size_t body = 0; body < robot.tree.bodies.size(); ++body) {
    skeleton.points.push_back({body, Vector3d::Zero()});
  }
  for (const hopper::ContactPoint& contact : robot.contacts) {
    skeleton.contacts.push_back(skeleton.points.size());
    skeleton.points.push_back(contact.point);
  }
  for (std::size_t body = 0; body < robot.tree.bodies.size(); ++body) {
    add_body(robot, body, skeleton);
  }
  return skeleton;
}

std::vector<Pose> poses_of(const hopper::Robot& robot, const Skeleton& skeleton,
                           const std::vector<double>& times_s, const Eigen::MatrixXd& positions) {
  dynamics::TreeState state(robot.tree);
  hopper::RobotCentroid centroid(robot);
  const Eigen::VectorXd at_rest = Eigen::VectorXd::Zero(robot.tree.velocity_size());
  std::vector<Pose> poses;
  for (std::size_t i = 0; i < times_s.size(); ++i) {
    const Eigen::VectorXd position = positions.col(static_cast<Eigen::Index>(i));
    state.set(position, at_rest);
    Pose& pose = poses.emplace_back();
    pose.time_s = times_s[i];
    for (const dynamics::BodyPoint& point : skeleton.points) {
      pose.points.push_back(seen(dynamics::point_position_m(state, point)));
    }
    pose.center_of_mass_m = seen(centroid.at(position, at_rest).position_m);
  }
  return poses;
}

std::vector<Pose> poses_at(const hopper::Robot& robot, const hopper::Motion& motion,
                           const Skeleton& skeleton, const std::vector<Eigen::Index>& samples) {
  std::vector<double> times_s;
  for (const Eigen::Index sample : samples) times_s.push_back(motion.time_s(sample));
  return poses_of(robot, skeleton, times_s, motion.positions(Eigen::all, samples));
}

}  // namespace torquewright::report
