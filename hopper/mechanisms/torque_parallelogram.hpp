// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <array>

#include "hopper/mechanisms/mechanism.hpp"

namespace torquewright::hopper {

/// What two actuators can do at two joints together, each between its least and its greatest torque
/// at its present speed: a parallelogram. docs/derivations/mechanisms.md eqs. (15), (16).
class TorqueParallelogram {
 public:
  /// Requires a transfer of two joints, and least <= most.
  TorqueParallelogram(const Transfer& transfer, const Eigen::Vector2d& least_Nm,
                      const Eigen::Vector2d& most_Nm);

  /// At the joints, in order round: actuators at (least, least), (most, least), (most, most),
  /// (least, most).
  std::array<Eigen::Vector2d, 4> corners_Nm() const;
  /// The actuators' torques for one at the joints.
  Eigen::Vector2d actuator_Nm(const Eigen::Vector2d& joint_Nm) const;
  /// Per actuator how far it is from its nearest limit; negative outside.
  Eigen::Vector2d margins_Nm(const Eigen::Vector2d& joint_Nm) const;
  /// The smaller one; at least 0 exactly where the torque lies in the parallelogram.
  double margin_Nm(const Eigen::Vector2d& joint_Nm) const;

 private:
  Eigen::Matrix2d jacobian_;
  Eigen::Vector2d least_Nm_;
  Eigen::Vector2d most_Nm_;
};

}  // namespace torquewright::hopper
