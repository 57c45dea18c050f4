// SPDX-License-Identifier: Apache-2.0
#include "hopper/flip/plan_options.hpp"
#include "hopper/flip/tasks/every_task.hpp"

namespace torquewright::hopper::tasks {
namespace {

void jump_goal(const PlanOptions& options, PlanGoal& goal) {
  goal.stride_m = 0.0;
  goal.rise_m = options.rise_m;
}

}  // namespace

// Off a whole sole at once no jump of the hopper was found, over the toe at once.
const PlanTask jump = {.name = "jump",
                       .sentence = "straight up",
                       .takes_rise = true,
                       .stances_of_a_sole = {"flat", "toe", "flight", "toe", "flat"},
                       .set_goal = jump_goal};

}  // namespace torquewright::hopper::tasks
