// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

namespace torquewright::simulation {

/// What a run prescribes to the motor.
enum class DriveKind {
  kCurrent,   ///< In A, in the actuator's convention.
  kTorque,    ///< In Nm at the output: current = torque / (N Kt).
  kVoltage,   ///< Of the winding, in V.
  kDuty,      ///< Winding voltage = duty times bus voltage.
  kPosition,  ///< Duty = clip(gain (value - position), -1, 1): a servo's own controller.
};

/// What drives one joint: values at the times of the excitation, straight lines between them.
struct JointDrive {
  DriveKind kind = DriveKind::kCurrent;
  std::vector<double> value;
  double position_gain_1_rad = 0.0;  ///< Of kPosition.
  std::vector<double> bus_V;         ///< As measured; empty: the document's, with what sags.
  std::vector<double> winding_K;     ///< As measured; empty: by the thermal data, else constant.
  std::vector<double> enabled;       ///< Below 0.5: the winding is open. Empty: always on.
  std::vector<double> speed_rad_s;   ///< Of the output where the plant imposes it; else unused.
};

struct Excitation {
  std::vector<double> time_s;  ///< Ascending.
  std::vector<JointDrive> joints;
};

/// Where a joint is when the simulation begins.
struct JointStart {
  double position_rad = 0.0;
  double speed_rad_s = 0.0;
  std::optional<double> winding_K, case_K;  ///< Absent: the reference temperature, the ambient one.
  double motor_ahead_rad = 0.0;  ///< Of an elastic train: motor angle over ratio less the output's.
};

struct SimulationOptions {
  double longest_step_s = 2.5e-4;  ///< Stiff parts (presliding, compliance, contact) get less.
  bool inductance = false;         ///< Of a voltage-driven winding; else it is quasi-static.
  /// Inertia of rotor and gears at the output, where another document states it; absent: the
  /// actuator's.
  std::optional<double> motor_inertia_kg_m2 = {};
};

}  // namespace torquewright::simulation
