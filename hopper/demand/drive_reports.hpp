// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "actuator/drive_check/report.hpp"
#include "hopper/demand/shared_bus.hpp"

namespace torquewright::hopper {

/// Torques of the drives, how they were chosen, and how well file and dynamics agree.
struct DriveTorques {
  Eigen::MatrixXd torque_Nm;  ///< Torques by drive and sample, at the actuator's output.
  Eigen::MatrixXd doubt_Nm;   ///< How far the torques may be off; empty: they are exact.
  actuator::InertiaConvention inertia = actuator::InertiaConvention::kIncluded;
  bool from_file = false;
  bool adds_rotors = false;  ///< The rotors' torques were added to the file's, which lack them.
  /// Whether the file's torques are no nearer to those of the dynamics than none at all, and nobody
  /// asked for them: a dead column, or one of another sign.
  bool is_doubtful = false;
  std::vector<Finding> findings;
};

/// Returns torques of the dynamics, rotors included, by drive and sample, in Nm. Without dynamics
/// those of the rotors alone.
Eigen::MatrixXd torques_by_dynamics(const Demand& demand);
/// Returns torques of the dynamics without the rotors'.
Eigen::MatrixXd load_torques_by_dynamics(const Demand& demand);

/// Chooses the drives' torques of the file or of the dynamics, as asked. Where both are there they
/// are compared, and the comparison tells whether the file's hold those of the rotors. Throws
/// io::SpecError where the file's are asked for and absent.
DriveTorques drive_torques(const CheckedMotion& checked);

/// Results of actuator::check() for every drive at its samples, on its battery's voltage. Where the
/// verdict turns on a doubt of the torques, it is undecided.
struct DriveReports {
  std::vector<actuator::DriveReport> drives;
  /// Traces, one for each drive, if asked for.
  std::vector<std::vector<actuator::TracePoint>> traces;
};
DriveReports check_drives(const CheckedMotion& checked, const DriveTorques& torques,
                          const std::vector<SharedBus>& buses);

/// Checks the drives of one drivetrain alone.
DriveReports check_drivetrain(const CheckedMotion& checked, const DriveTorques& torques,
                              const std::vector<SharedBus>& buses, std::size_t drivetrain);

}  // namespace torquewright::hopper
