// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hopper/demand/drive_reports.hpp"

namespace torquewright::hopper {

/// The torque that passes each transmission: what its motor makes, less what its rotor's speed and
/// the friction on the motor's side take. docs/derivations/whole_body_check.md eqs. (14)-(19).
/// All (drives x samples).
struct GearTorque {
  Eigen::MatrixXd joint_Nm;      ///< Torque behind the mesh, at the actuator's output.
  Eigen::MatrixXd motor_Nm;      ///< Torque before the mesh, at the rotor.
  Eigen::MatrixXd impulse_Nm_s;  ///< Impulse of the rotor's jump in speed, at the output; else 0.
  /// Impulse at the output, since the sample before, that the velocities' change asks for and the
  /// samples do not give.
  Eigen::MatrixXd doubt_Nm_s;
  /// How far the impulse since the sample before may be off by a jump or bend between samples and
  /// by the doubt of the torques.
  Eigen::MatrixXd bend_Nm_s;
};

/// Computes what passes the gears under the torques that count. Requires velocities and
/// accelerations, as demand_of() leaves them.
GearTorque gear_torque(const CheckedMotion& checked, const DriveTorques& torques);

}  // namespace torquewright::hopper
