// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "robot/model/robot.hpp"

namespace torquewright::report {

/// Where a robot's bodies are at instants, a column each: what a picture needs, in few bytes.
struct BodyPoses {
  /// Origins of the bodies' frames in the world's axes, three rows a body, then the centre of mass.
  Eigen::MatrixXf places_m;
  /// Quaternions w, x, y, z of R_WB, four rows a body, in parts of kWholeTurn.
  Eigen::Matrix<std::int16_t, Eigen::Dynamic, Eigen::Dynamic> turns;

  Eigen::Vector3d place_m(std::size_t body, Eigen::Index instant) const;
  Eigen::Vector3d center_of_mass_m(Eigen::Index instant) const;
  Eigen::Matrix3d rotation(std::size_t body, Eigen::Index instant) const;
};
constexpr double kWholeTurn = 32767.0;

/// `positions`: a column an instant, rows as those of the robot's tree.
BodyPoses body_poses(const hopper::Robot& robot, const Eigen::MatrixXd& positions);

}  // namespace torquewright::report
