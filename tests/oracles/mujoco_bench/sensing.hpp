// SPDX-License-Identifier: Apache-2.0
// From what happened to what is logged.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "tests/oracles/mujoco_bench/bench.hpp"
#include "tests/oracles/mujoco_bench/draws.hpp"

namespace torquewright::oracles::mujoco_bench {

/// White noise (standard deviation) and the smallest step of a channel's number.
struct Grain {
  double noise = 0, quantum = 0;
};

/// Channels by their quantity, in the order of the log's columns.
using Channels = std::map<std::string, std::vector<double>>;

struct LogFormat {
  std::vector<std::string> quantities;
  std::map<std::string, Grain> grains;
  int records_per_row = 2;

  bool has(const std::string& quantity) const;
  double row_s() const { return records_per_row * kRecord_s; }
};

/// What the sensors would say without noise; row by row of the log.
Channels sense(const World& world, const LogFormat& format, const Record& record);

void add_noise(Channels& channels, const LogFormat& format, Draws& draws);

/// Every `stride`-th number.
std::vector<double> thinned(const std::vector<double>& numbers, int stride);

}  // namespace torquewright::oracles::mujoco_bench
