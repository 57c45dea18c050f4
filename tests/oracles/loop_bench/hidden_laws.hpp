// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/oracles/loop_bench/draws.hpp"
#include "tests/oracles/loop_bench/situation.hpp"

namespace torquewright::oracles::loop {

/// Names that may be hidden in such a rig.
std::vector<std::string> names_for(const Rig& rig, bool logs_voltage);
std::vector<std::string> names_outside();

/// Hides a law of this name in the situation's joint, of this share of the torque that the rig
/// takes, and leaves out of the documents what it replaces.
void hide(const std::string& name, double share, double scale_Nm, Draws& draws, Situation& it);

}  // namespace torquewright::oracles::loop
