// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "actuator/motor/position_law.hpp"

namespace torquewright::simulation {

/// The quantity of the drive that a run prescribes.
enum class DriveKind {
  kCurrent,  ///< Current in A, in the actuator's convention.
  kTorque,   ///< Torque in Nm at the output: current = torque / (N Kt).
  kVoltage,  ///< Voltage of the winding, in V.
  kDuty,     ///< Duty: winding voltage = duty times bus voltage.
  /// Position of a servo with its own controller: duty = clip(gain (value - position), -1, 1).
  kPosition,
  /// Position of a joint whose own controller makes a torque of it, by its law.
  kPositionLaw,
};

/// The drive of one joint: values at the times of the excitation, linear between them.
struct JointDrive {
  DriveKind kind = DriveKind::kCurrent;
  std::vector<double> value;
  double position_gain_1_rad = 0.0;  ///< Gain of kPosition.
  actuator::PositionLaw law;         ///< Law of kPositionLaw.
  std::vector<double> bus_V;         ///< Measured bus voltage; empty: the document's, with its sag.
  /// Measured winding temperature; empty: by the thermal data, else constant.
  std::vector<double> winding_K;
  std::vector<double> enabled;  ///< Below 0.5: the winding is open. Empty: always on.
  /// Speed of the output where the plant imposes it; else unused.
  std::vector<double> speed_rad_s;
};

struct Excitation {
  std::vector<double> time_s;  ///< Ascending.
  std::vector<JointDrive> joints;
};

/// State of a joint when the simulation begins.
struct JointStart {
  double position_rad = 0.0;
  double speed_rad_s = 0.0;
  /// Temperatures; absent: the reference temperature, the ambient one.
  std::optional<double> winding_K, case_K;
  double motor_ahead_rad = 0.0;  ///< Elastic train: motor angle over ratio less the output's.
};

struct SimulationOptions {
  /// Longest step; stiff parts (presliding, compliance, contact) get shorter ones.
  double longest_step_s = 2.5e-4;
  /// Whether the inductance of a voltage-driven winding counts; else it is quasi-static.
  bool inductance = false;
  /// Inertia of rotor and gears at the output, where another document states it; absent: the
  /// actuator's.
  std::optional<double> motor_inertia_kg_m2 = {};
  /// Whether traces hold positions and speeds of the output alone: torques at the samples cost an
  /// evaluation of the dynamics each. A motion that is not imposed.
  bool traces_motion_only = false;
};

}  // namespace torquewright::simulation
