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

/// What of an equation's measured side comes from which channel. docs/derivations/identification.md
enum class Drive {
  kCurrent,  ///< Measured.
  kTorque,   ///< The driver's report or command: current = torque / (N Kt).
  kVoltage,  ///< Quasi-static winding: current = (V - Ke N w) / R.
};
enum class LoadSide {
  kSensor,  ///< A torque or force sensor measures what the load takes.
  kModel,   ///< Inertia and gravity of the rig say what it takes.
};

/// Of one joint of an arm; vectors of one length.
struct JointMotion {
  std::vector<double> position_rad, velocity_rad_s, acceleration_rad_s2;
};

/// One stretch of one joint on a uniform grid, in the band of the raw channels: the instants at
/// which effects are asked, and the two sides of the torque balance. All vectors are of one length,
/// but for the voltage's fast part.
struct Signals {
  std::size_t run = 0;  ///< Index into RunTable.
  std::string run_name;
  double step_s = 0.0;         ///< Of the grid.
  double sample_step_s = 0.0;  ///< Of the log, mean; 0 in a map without time.
  double cutoff_Hz = 0.0;      ///< Of the low-pass that they have passed; 0: none.
  double pole_pairs = 1.0;
  double start_s = 0.0;
  std::vector<double> time_s;
  std::vector<actuator::Instant> at;  ///< Output side; current from the drive's side.
  /// Of the motion, through the low-pass of the channels: what they hold of a friction's step, with
  /// the overshoot of a filter. `at` holds it as it is; empty: these are all that there is.
  std::vector<double> filtered_direction;
  std::vector<double> motor_side_Nm;  ///< N Kt i of the stated constants.
  std::vector<double> load_side_Nm;   ///< On the load: sensor, or the rig's model.
  /// Of a current that was measured beside a voltage: its sign, through the same low-pass, and its
  /// rate; else empty, and in a map without time.
  std::vector<double> filtered_current_sign, current_rate_A_s;
  std::vector<double> voltage_V;  ///< Of the winding; empty if unknown.
  /// What the low-pass took of the voltage, at the log's own samples: `raw_per_sample` for each, of
  /// a drive that is known by its voltage; else empty.
  std::vector<double> fast_voltage_V;
  std::size_t raw_per_sample = 1;
  std::vector<double> bus_V;
  std::vector<double> bus_A;
  std::vector<double> logged_velocity_rad_s;
  std::vector<double> motor_velocity_rad_s;
  /// Of the rotor over the ratio, where it has an encoder beside the output's; else empty.
  std::vector<double> motor_acceleration_rad_s2;
  std::vector<double> twist_rad;     ///< Motor angle over ratio less output angle.
  std::vector<JointMotion> arm;      ///< Of every joint of a serial arm; else empty.
  std::vector<std::uint8_t> masked;  ///< 1: masked in the log, or the drive is off.
  std::vector<std::uint8_t> usable;  ///< 0: masked in the log, at rest, or near an end.
  /// Of a piece of a stretch: samples before and behind these belong to other pieces, and are there
  /// so that filters do not see the cut.
  std::size_t core_begin = 0;
  std::size_t core_end = static_cast<std::size_t>(-1);
  std::size_t size() const { return at.size(); }
  std::size_t core_size() const { return std::min(core_end, size()) - core_begin; }
};

}  // namespace torquewright::identification
