// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "hopper/replay/result.hpp"

namespace torquewright::hopper {

/// An effect of a drive's document that a replay of this robot leaves out, and why.
struct EffectLeftOut {
  std::string drive;
  std::string effect;
  std::string reason;  ///< What in the robot's document keeps it from acting, and what would help.
};

/// Returns the effects that are left out, in the order of the drives. A replay holds every effect,
/// but for rotors that the robot's joints state: a train is elastic only where its rotor's inertia
/// is known apart from others' (free_rotors.hpp), and inertia that an effect adds has no place
/// beside a joint's own.
std::vector<EffectLeftOut> effects_left_out(const Robot& robot);

/// Adds findings about them; a run that ended is then undecided.
void leave_open(const std::vector<EffectLeftOut>& effects, ReplayResult& result);

}  // namespace torquewright::hopper
