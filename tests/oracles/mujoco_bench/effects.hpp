// SPDX-License-Identifier: Apache-2.0
// Draws of effects: one number scales them from nothing to the most that a plant can have.
#pragma once

#include "tests/oracles/mujoco_bench/rigs.hpp"

namespace torquewright::oracles::mujoco_bench {

/// Names of the effects that class `one` draws from.
const std::vector<std::string>& effect_names();

/// What a rig needs to show this effect, drawn with the same `draws` that `make_effect` gets.
Demand demand_of(const std::string& effect, Draws draws);

/// `scale` from 0 (nothing) to 1; everything else about it follows from `draws`, whatever the
/// scale.
Effect make_effect(const std::string& name, double scale, const Situation& it, Draws draws);

/// Effects that have to be stated for this one to have something to act on.
std::vector<Effect> companions(const std::string& effect, const Situation& it, Draws& draws);

/// Whether both may stand in one world: no two laws for one and the same friction, offset, or
/// lateness.
bool agree(const std::string& a, const std::string& b);

/// The effect's own name and those that are the same whatever is played on that rig.
std::vector<std::string> identical_names(const Effect& effect, const Situation& it);

}  // namespace torquewright::oracles::mujoco_bench
