// SPDX-License-Identifier: Apache-2.0
// A robot, its loops, what is missing in its documents, and how it is logged.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "tests/oracles/mujoco_bench/draws.hpp"
#include "tests/oracles/robot_bench/effects.hpp"
#include "tests/oracles/robot_bench/plant.hpp"

namespace torquewright::oracles::robot_bench {

struct Format {
  double row_s = 0.005, encoder_step_rad = 4e-4, noise_rad = 1e-4;
  bool has_speed = false;
  double speed_filter_s = 0.01, speed_step_rad_s = 0;

  /// Of one position in the log.
  double floor_rad() const;
};

/// Numbers of an actuator document, where there is one: dc winding behind gears.
struct Drive {
  double ratio = 9, torque_constant_Nm_A = 0.1, resistance_ohm = 0.2, bus_voltage_V = 48;
};

struct Situation {
  std::string kind;
  Scene truth, stated;
  std::vector<Commands> runs;
  Format format;
  std::map<std::string, Usage> usage;
  std::map<std::string, Drive> drives;  ///< Empty: the robot's document has the joints' values.
  double stated_delay_s = 0;
  bool servo = false;  ///< The loop's stiffness is not published.
  double servo_guess = 1;
  bool uses_patterns = false;
  std::vector<std::string> uncertain;
  std::string only;  ///< What may be missing of the drives; empty: anything.

  std::vector<Effect> missing;
  Json outside, load;
  /// Change of the most affected joint's measured position over the encoder's floor, by effect.
  std::vector<double> size_floors;
  std::map<std::string, double> floors_by_joint;  ///< Of all together.
};

/// Classes: none, one, alike, two, load, outside, gantry. `only`: the effect that is missing;
/// empty: any. Throws std::invalid_argument.
Situation draw_situation(const std::string& kind, std::uint64_t seed,
                         const std::filesystem::path& data, const std::string& only = "");

/// Root mean square, joint by joint, between two scenes under the same commands.
std::vector<double> differences_rad(const Scene& one, const Scene& other, const Commands& commands);

}  // namespace torquewright::oracles::robot_bench
