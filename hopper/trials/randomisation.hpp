// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "hopper/trials/named_range.hpp"
#include "robot/model/robot.hpp"

namespace torquewright::hopper {

struct ShiftRange {
  NamedRange of_bodies;
  std::array<bool, 3> along{true, true, true};  ///< The body's own axes, each drawn by itself.
};

enum class NoiseDistribution {
  kUniform,  ///< The number is half the width.
  kNormal,   ///< The number is the standard deviation.
};

/// Noise of what a controller sees, drawn anew at every look; 0: none.
struct SensorNoiseLevels {
  NoiseDistribution distribution = NoiseDistribution::kUniform;
  double gravity_direction = 0.0;  ///< On each part of the unit vector in the base's axes.
  double base_rate_rad_s = 0.0;    ///< About each axis of the base.
  double base_position_m = 0.0;
  double base_velocity_m_s = 0.0;
  double joint_position_rad = 0.0;  ///< Position of revolute joints, as the next.
  double joint_velocity_rad_s = 0.0;
};

/// A document of kind `randomisation`: what trials of a replay draw (docs/randomisation.md). What
/// is absent stays as robot, replay and controller have it.
struct Randomisation {
  std::string file;                          ///< File name as the user gave it.
  std::optional<Range> total_mass_factor;    ///< One factor for all bodies, times their own.
  std::vector<NamedRange> body_mass_factor;  ///< Factors by body.
  /// Factors by body, on the inertia about its centre of mass.
  std::vector<NamedRange> body_inertia_factor;
  std::vector<ShiftRange> center_of_mass_shift_m;
  std::vector<NamedRange> controller_gain_factor;  ///< Factors by drive.
  /// Factors by drive, on the torque that its motor makes of a current.
  std::vector<NamedRange> motor_strength_factor;
  /// Friction by drive, behind the gears, at its output.
  std::vector<NamedRange> further_friction_Nm;
  /// Coefficient of the ground, in place of all contacts'.
  std::optional<Range> friction_coefficient;
  std::optional<Range> restitution;      ///< So too.
  std::optional<Range> ground_height_m;  ///< Added to the replay's; so the next.
  std::optional<Range> latency_s;        ///< Additional delay of what the controller sees.
  std::optional<Range> state_of_charge;
  /// Factor on the voltage that drives have without load.
  std::optional<Range> bus_voltage_factor;
  std::optional<Range> winding_temperature_K;
  std::vector<NamedRange> initial_joint_position_rad;  ///< Added at the start, by revolute joint.
  std::vector<NamedRange> initial_joint_velocity_rad_s;
  SensorNoiseLevels noise;
  std::vector<std::string> assumed;  ///< JSON pointers.
};

/// Throws io::SpecError with all that does not go together: names the robot does not have (with the
/// nearest), one that two ranges of a key give, charges and temperatures that its actuators cannot
/// have.
void require_fits(const Randomisation& randomisation, const Robot& robot);

}  // namespace torquewright::hopper
