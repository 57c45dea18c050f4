// SPDX-License-Identifier: Apache-2.0
// One log to be: what is true, what is stated, what is logged, and what is to be found.
#pragma once

#include <string>
#include <vector>

#include "tests/oracles/mujoco_bench/sensing.hpp"

namespace torquewright::oracles::mujoco_bench {

struct Situation {
  std::string kind;  ///< Class of the log: none, one, two, undecidable, outside, coulomb_load.
  Bench bench;       ///< Its world holds everything that is true.
  World stated;      ///< As the documents have it.
  std::vector<Effect> declared, missing;
  LogFormat format;
  std::vector<std::string> uncertain, holdout_runs;
  std::vector<std::vector<std::string>> accept;
  std::vector<double> size_floors;
  std::vector<std::string> outside_coordinates;
  double noise_Nm = 0;
  std::string note;

  double peak_torque_Nm() const {
    return bench.world.motor.gain_Nm_A() * bench.world.motor.peak_current_A;
  }
  double top_speed_rad_s = 10;
};

/// Everything that is logged and written, from one seed.
struct Made {
  Situation situation;
  std::vector<Record> records;
};

/// @throws std::invalid_argument for a class that does not exist.
Made make_log(const std::string& kind, std::uint64_t seed);

}  // namespace torquewright::oracles::mujoco_bench
