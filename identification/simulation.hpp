// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "actuator/motor/actuator.hpp"
#include "identification/rig.hpp"

namespace torquewright::identification {

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
  std::vector<double> speed_rad_s;   ///< Of the output where the rig imposes it; else unused.
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
};

/// The truth of one joint at the times of the excitation.
struct JointTrace {
  std::vector<double> position_rad, speed_rad_s, acceleration_rad_s2;  ///< Output.
  std::vector<double> motor_position_rad, motor_speed_rad_s;           ///< Rotor.
  std::vector<double> current_A, voltage_V, bus_V;
  std::vector<double> torque_Nm;  ///< On the load.
  std::vector<double> winding_K, case_K;
};

/// Work since the start, of all joints, in J. Put in less lost is stored, to the scheme's order.
struct WorkAccount {
  double motor_J = 0.0;     ///< Put in by the motors' torque.
  double load_J = 0.0;      ///< Put in by what imposes the motion.
  double periodic_J = 0.0;  ///< Put in by cogging and ripple.
  double friction_J = 0.0;  ///< Taken by friction (what bristles store included).
  double mesh_J = 0.0;      ///< Taken by the gears.
  double damper_J = 0.0;    ///< Taken by what damps a twist.
  double stored_J = 0.0;    ///< In motion, height and twist: gained.
};

struct SimulatedRun {
  std::vector<JointTrace> joints;
  WorkAccount work;
  double step_s = 0.0;    ///< Longest that was taken.
  bool is_finite = true;  ///< False: it diverged; the traces end where it did.
};

/// Simulates actuators on a rig by the laws of actuator/effects, those with a state included.
/// Sticking is exact: a joint at rest stays there until the torque leaves what friction can hold,
/// and motion that reverses stops at an instant of its own. Second order in the step.
/// docs/derivations/simulation.md. Sizes must agree, times ascend (std::invalid_argument); a free
/// load needs inertia.
SimulatedRun simulate(const Rig& rig, const std::vector<const actuator::Actuator*>& actuators,
                      const Excitation& excitation, const std::vector<JointStart>& start,
                      const SimulationOptions& options = {});

/// Only the samples from `first` up to and including `last` of an excitation.
SimulatedRun simulate_part(const Rig& rig, const std::vector<const actuator::Actuator*>& actuators,
                           const Excitation& excitation, const std::vector<JointStart>& start,
                           std::size_t first, std::size_t last, const SimulationOptions& options);

}  // namespace torquewright::identification
