// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "actuator/effects/effect.hpp"
#include "identification/log/log.hpp"

namespace torquewright::identification {

/// Source of the motor's torque in an equation (docs/derivations/identification.md section 1).
enum class Drive {
  kCurrent,  ///< A measured current.
  kTorque,   ///< The driver's report or command: current = torque / (N Kt).
  kVoltage,  ///< A quasi-static winding: current = (V - Ke N w) / R.
};
enum class LoadSide {
  kSensor,  ///< A torque or force sensor measures what the load takes.
  kModel,   ///< Inertia and gravity of the rig's model say what the load takes.
};

/// Motion of one joint of an arm; vectors of one length.
struct JointMotion {
  std::vector<double> position_rad, velocity_rad_s, acceleration_rad_s2;
};

/// One stretch of one joint on a uniform grid, in the band of the raw channels: the samples at
/// which effects are evaluated, and the two sides of the torque balance. All vectors have one
/// length, but for the voltage's fast part.
struct Signals {
  std::size_t run = 0;  ///< Index into RunTable.
  std::string run_name;
  double step_s = 0.0;         ///< Step of the grid.
  double sample_step_s = 0.0;  ///< Mean step of the log; 0 in a map without time.
  bool is_steady = false;      ///< Its samples are steady states, in no order of time.
  double cutoff_Hz = 0.0;      ///< Cut-off of the low-pass that they have passed; 0: none.
  double pole_pairs = 1.0;
  double start_s = 0.0;
  std::vector<double> time_s;
  /// State on the output's side; the current comes from the drive's side.
  std::vector<actuator::Instant> at;
  /// Direction of the motion through the low-pass of the channels: what they hold of a friction's
  /// step, with the overshoot of a filter. `at` holds the unfiltered one; empty: only that is
  /// known.
  std::vector<double> filtered_direction;
  std::vector<double> motor_side_Nm;  ///< N Kt i, with the stated constants.
  std::vector<double> load_side_Nm;   ///< Torque on the load, by a sensor or by the rig's model.
  /// Sign of a current that was measured beside a voltage, through the same low-pass, and the
  /// current's rate; empty else, and in a map without time.
  std::vector<double> filtered_current_sign, current_rate_A_s;
  std::vector<double> voltage_V;  ///< Voltage of the winding; empty if unknown.
  /// What the low-pass removed from the voltage, at the log's own samples, `raw_per_sample` for
  /// each sample, for a drive that is known by its voltage; empty else.
  std::vector<double> fast_voltage_V;
  std::size_t raw_per_sample = 1;
  std::vector<double> bus_V;
  std::vector<double> bus_A;
  std::vector<double> logged_velocity_rad_s;
  std::vector<double> motor_velocity_rad_s;
  /// Acceleration of the rotor over the ratio, where it has an encoder beside the output's; empty
  /// else.
  std::vector<double> motor_acceleration_rad_s2;
  std::vector<double> twist_rad;     ///< Motor angle over ratio less output angle.
  std::vector<JointMotion> arm;      ///< Motion of every joint of a serial arm; empty else.
  std::vector<std::uint8_t> masked;  ///< 1: masked in the log, or the drive is off.
  std::vector<std::uint8_t> usable;  ///< 0: masked in the log, at rest, or near an end.
  /// First sample that belongs to this piece of a stretch. Samples before it, and behind
  /// `core_end`, belong to other pieces and are there so that filters do not see the cut.
  std::size_t core_begin = 0;
  std::size_t core_end = static_cast<std::size_t>(-1);
  std::size_t size() const { return at.size(); }
  std::size_t core_size() const { return std::min(core_end, size()) - core_begin; }
};

}  // namespace torquewright::identification
