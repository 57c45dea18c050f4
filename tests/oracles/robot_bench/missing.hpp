// SPDX-License-Identifier: Apache-2.0
// What is there in truth and in no document, class by class, sized against the encoder's noise.
#pragma once

#include <string>
#include <vector>

#include "tests/oracles/robot_bench/situation.hpp"

namespace torquewright::oracles::robot_bench {

std::vector<std::string> class_names();

/// Least and greatest size of what is missing: change of a joint's position over the floor.
constexpr double kLeastFloors = 3, kMostFloors = 100;

/// From the stated scene (and how its base hangs) to the true one.
void draw_missing(mujoco_bench::Draws& draws, Situation& it);

/// The part of a run on which sizes are taken.
Commands sizing_piece(const Situation& it);

/// What stays of the change at `joints` when the usual numbers of these joints (armature, both
/// frictions, gain, spring, a constant torque, delay, mass of the body) do their best to stand for
/// it, by linearisation; over the floor.
double distinct_floors(const Situation& it);

}  // namespace torquewright::oracles::robot_bench
