// SPDX-License-Identifier: Apache-2.0
#include <numbers>

#include "hopper/flip/tasks/every_task.hpp"

namespace torquewright::hopper::tasks {
namespace {

void flip_goal(const PlanOptions& /*options*/, PlanGoal& goal) {
  goal.turn_rad = 2.0 * std::numbers::pi;
}

}  // namespace

const PlanTask flip = {.name = "flip",
                       .sentence = "the foot turned once forwards",
                       .stances_of_a_sole = {"flat", "heel", "flight", "heel", "flat"},
                       .set_goal = flip_goal};

}  // namespace torquewright::hopper::tasks
