// SPDX-License-Identifier: Apache-2.0
#include "src/report/turning/body_poses.hpp"

#include <Eigen/Geometry>
#include <cmath>

#include "dynamics/point.hpp"
#include "robot/model/robot_centroid.hpp"

namespace torquewright::report {
namespace {

using Eigen::Index;
using Eigen::Vector3d;

Eigen::Matrix<std::int16_t, 4, 1> in_few_bytes(const Eigen::Matrix3d& rotation) {
  const Eigen::Quaterniond turn(rotation);
  Eigen::Matrix<std::int16_t, 4, 1> parts;
  const Eigen::Vector4d all(turn.w(), turn.x(), turn.y(), turn.z());
  for (Index i = 0; i < 4; ++i) {
    parts[i] = static_cast<std::int16_t>(std::lround(kWholeTurn * all[i]));
  }
  return parts;
}

}  // namespace

Vector3d BodyPoses::place_m(std::size_t body, Index instant) const {
  return places_m.col(instant).segment<3>(3 * static_cast<Index>(body)).cast<double>();
}

Vector3d BodyPoses::center_of_mass_m(Index instant) const {
  return places_m.col(instant).tail<3>().cast<double>();
}

Eigen::Matrix3d BodyPoses::rotation(std::size_t body, Index instant) const {
  const Eigen::Vector4d parts =
      turns.col(instant).segment<4>(4 * static_cast<Index>(body)).cast<double>();
  return Eigen::Quaterniond(parts[0], parts[1], parts[2], parts[3]).normalized().matrix();
}

BodyPoses body_poses(const hopper::Robot& robot, const Eigen::MatrixXd& positions) {
  const std::size_t bodies = robot.tree.bodies.size();
  const auto count = static_cast<Index>(bodies);
  BodyPoses poses;
  poses.places_m.resize(3 * (count + 1), positions.cols());
  poses.turns.resize(4 * count, positions.cols());
  dynamics::TreeState state(robot.tree);
  hopper::RobotCentroid centroid(robot);
  const Eigen::VectorXd at_rest = Eigen::VectorXd::Zero(robot.tree.velocity_size());
  for (Index instant = 0; instant < positions.cols(); ++instant) {
    const Eigen::VectorXd position = positions.col(instant);
    state.set(position, at_rest);
    for (std::size_t body = 0; body < bodies; ++body) {
      const auto row = static_cast<Index>(body);
      poses.places_m.col(instant).segment<3>(3 * row) =
          dynamics::point_position_m(state, {body, Vector3d::Zero()}).cast<float>();
      poses.turns.col(instant).segment<4>(4 * row) = in_few_bytes(state.motion(body).R_WB);
    }
    poses.places_m.col(instant).tail<3>() = centroid.at(position, at_rest).position_m.cast<float>();
  }
  return poses;
}

}  // namespace torquewright::report
