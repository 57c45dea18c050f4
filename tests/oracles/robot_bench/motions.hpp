// SPDX-License-Identifier: Apache-2.0
// What the host asks the joints to do.
#pragma once

#include "tests/oracles/mujoco_bench/draws.hpp"
#include "tests/oracles/robot_bench/plant.hpp"

namespace torquewright::oracles::robot_bench {

/// All joints at once, each about the middle of its range: sums of waves, a sweep, straight lines
/// between set-points, ramps with rests. `speed` 0 to 1: from slow to fast.
Commands draw_motion(mujoco_bench::Draws& draws, const Robot& robot, double duration_s,
                     double packet_s, double speed);

}  // namespace torquewright::oracles::robot_bench
