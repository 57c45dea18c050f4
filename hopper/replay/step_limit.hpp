// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dynamics/tree_state.hpp"
#include "hopper/robot/robot.hpp"

namespace torquewright::hopper {

/// The longest step of an engine in which it follows what effects do at each drive's output
/// (springs, stops, bristles, trains that give way): forces are held over a step, so that a swing
/// may turn by a quarter of a radian in it, which keeps its frequency to 0.3 %, and what damps it
/// may take half of a speed. Throws io::SpecError, naming drive and step, where `step_s` is longer.
/// Inertias are those that outputs feel in that posture, all joints free.
void require_steps_follow_effects(const Robot& robot, const dynamics::VectorIn& position,
                                  double step_s);

}  // namespace torquewright::hopper
