// SPDX-License-Identifier: Apache-2.0
#include "hopper/planning/tasks/every_task.hpp"
#include "hopper/planning/tasks/plan_options.hpp"

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
                       .takes_repeat = true,
                       .stances_of_a_sole = {"flat", "toe", "flight", "toe", "flat"},
                       .set_goal = jump_goal};

}  // namespace torquewright::hopper::tasks
