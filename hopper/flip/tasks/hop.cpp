// SPDX-License-Identifier: Apache-2.0
#include "hopper/flip/plan_options.hpp"
#include "hopper/flip/tasks/every_task.hpp"

namespace torquewright::hopper::tasks {
namespace {

void hop_goal(const PlanOptions& options, PlanGoal& goal) {
  goal.stride_m = options.stride_m;
  goal.rise_m = options.rise_m;
}

}  // namespace

// Over the toe, as a jump.
const PlanTask hop = {.name = "hop",
                      .sentence = "with a stride",
                      .takes_rise = true,
                      .takes_stride = true,
                      .stances_of_a_sole = {"flat", "toe", "flight", "toe", "flat"},
                      .set_goal = hop_goal};

}  // namespace torquewright::hopper::tasks
