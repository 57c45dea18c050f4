// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/oracles/mujoco_bench/rigs.hpp"

namespace torquewright::oracles::mujoco_bench {

/// Rich excitation: both directions, speeds and loads of many levels, driving and driven back.
void draw_runs(Situation& it, Draws& draws, const Demand& demand);

}  // namespace torquewright::oracles::mujoco_bench
