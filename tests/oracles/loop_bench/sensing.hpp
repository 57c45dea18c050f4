// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tests/oracles/loop_bench/motion.hpp"

namespace torquewright::oracles::loop {

/// What the recorder sees, and how.
struct Sensing {
  double rate_Hz = 1000.0;
  double counts_per_turn = 65536.0;  ///< Of the encoder at the output.
  double current_filter_Hz = 500.0;  ///< Of first order.
  double current_noise_A = 0.01, current_delay_s = 0.0, current_offset_A = 0.0;
  double voltage_noise_V = 0.01;         ///< Of the bus; a duty is set.
  bool logs_velocity = true;             ///< Differences of the logged position, half a row late.
  bool logs_voltage = false;             ///< Duty and the bus' voltage in the place of the current.
  std::vector<std::string> joint_names;  ///< Empty where there is one joint.
  std::uint64_t seed = 0;
};

/// Values of one joint in one row.
struct Sample {
  double position_rad = 0.0, velocity_rad_s = 0.0, current_A = 0.0, duty = 0.0, bus_V = 0.0;
};
struct Row {
  double time_s = 0.0;
  std::vector<Sample> joints;
};
using Record = std::vector<Row>;  ///< Of one run.

Record sensed(const Rig& rig, const Sensing& sensing, const std::vector<State>& states,
              std::uint64_t run);

}  // namespace torquewright::oracles::loop
