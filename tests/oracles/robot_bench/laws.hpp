// SPDX-License-Identifier: Apache-2.0
// What each joint's drive does in truth. Neutral values change nothing.
#pragma once

#include <limits>
#include <string>
#include <vector>

namespace torquewright::oracles::robot_bench {

constexpr double kNever = std::numeric_limits<double>::infinity();

/// A sin(order angle + phase).
struct Harmonic {
  double order = 1, amplitude_Nm = 0, phase_rad = 0;
};

struct Stop {
  double stiffness_Nm_rad = 0, angle_rad = 0;
};

/// All torques at the joint. Pairs: forwards, backwards.
struct Laws {
  double armature_kg_m2 = 0;
  double coulomb_Nm[2] = {0, 0}, viscous_Nm_s_rad[2] = {0, 0};
  double breakaway_excess_Nm = 0, stribeck_velocity_rad_s = 1;
  /// Shares of the torque that passes the gears to the link.
  double driving_coefficient = 0, backdriving_coefficient = 0;
  std::vector<Harmonic> ripple;
  double spring_Nm_rad = 0, spring_neutral_rad = 0;
  Stop upper{0, kNever}, lower{0, -kNever};
  double torque_factor = 1, lag_s = 0;
  double command_delay_s = 0;  ///< Beyond the stated one.
  // Between rotor and output; with a slip torque the rotor is what is measured.
  double gap_rad = 0, stiffness_Nm_rad = kNever, twist_damping_Nm_s_rad = 0;
  double slip_torque_Nm = kNever;

  bool is_elastic() const { return gap_rad > 0 || stiffness_Nm_rad < kNever; }
  bool slips() const { return slip_torque_Nm < kNever; }

  /// Dry friction's level, given the speed, its direction and what passes the gears.
  double dry_Nm(double speed_rad_s, bool forwards, double gear_torque_Nm) const;
  double stops_Nm(double position_rad) const;
  double spring_and_ripple_Nm(double position_rad) const;
};

/// torque = stiffness (command - position) - damping speed, cut at the limit.
struct Controller {
  double stiffness_Nm_rad = 20, damping_Nm_s_rad = 1, torque_limit_Nm = kNever;

  double torque_Nm(double command_rad, double position_rad, double speed_rad_s) const;
};

/// Pulls a point of one body towards a point of another; slack below its free length.
struct Cable {
  std::string from, to;
  double from_m[3] = {0, 0, 0}, to_m[3] = {0, 0, 0};
  double tension_N = 0, stiffness_N_m = 0, free_m = 0;

  bool pulls() const { return !to.empty(); }
};

/// The base hangs on two hinges, roll and pitch, this far above its origin.
struct Gantry {
  double above_m = 0, frequency_hz = 0, damping_ratio = 0.05;

  bool gives_way() const { return frequency_hz > 0; }
};

}  // namespace torquewright::oracles::robot_bench
