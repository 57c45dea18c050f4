// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/oracles/sampled_bench/bench.hpp"
#include "tests/oracles/sampled_bench/drive_train.hpp"

namespace torquewright::oracles::sampled {

/// Where the reference is.
struct Target {
  double run_time_s = 0.0;
  double angle_rad = 0.0, speed_rad_s = 0.0, acceleration_rad_s2 = 0.0;
};

/// The drive's controller: what it commands for the next control period.
double command_of(const Plant& plant, const RunPlan& plan, const Instant& now,
                  const Target& target);

}  // namespace torquewright::oracles::sampled
