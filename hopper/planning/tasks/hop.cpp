// SPDX-License-Identifier: Apache-2.0
#include "hopper/planning/tasks/every_task.hpp"
#include "hopper/planning/tasks/plan_options.hpp"

namespace torquewright::hopper::tasks {
namespace {

constexpr double kStride_m = 0.1;  // where nobody says how far

void hop_goal(const PlanOptions& options, PlanGoal& goal) {
  // A speed without a stride makes one.
  if (options.stride_m || !options.speed_m_s) goal.stride_m = options.stride_m.value_or(kStride_m);
  goal.rise_m = options.rise_m;
}

}  // namespace

// Over the toe, as a jump.
const PlanTask hop = {.name = "hop",
                      .sentence = "with a stride",
                      .takes_rise = true,
                      .takes_stride = true,
                      .takes_repeat = true,
                      .stances_of_a_sole = {"flat", "toe", "flight", "toe", "flat"},
                      .set_goal = hop_goal};

}  // namespace torquewright::hopper::tasks
