// SPDX-License-Identifier: Apache-2.0
// Draws of plants and of what is logged of them.
#pragma once

#include "tests/oracles/mujoco_bench/situation.hpp"

namespace torquewright::oracles::mujoco_bench {

/// What a rig must have, to show what is asked of it.
struct Demand {
  std::vector<std::string> loads = {"dynamometer", "free", "pendulum", "linear_axis"};
  bool temperature = false, two_encoders = false, velocity = false;
  /// current, duty (with bus voltage), any.
  std::string drive = "any";
  /// Orders per turn of rotor or output that some runs must play slowly; 0: none.
  double rotor_order = 0, output_order = 0;
  bool fast_torque = false;  ///< Currents up to 15 Hz.
  bool gentle = false;       ///< Accelerates slowly and is logged for a short time.
};

/// Motor, gear, load, channels, noise, and what is played; no effect yet.
Situation draw_rig(Draws& draws, const Demand& demand);

}  // namespace torquewright::oracles::mujoco_bench
