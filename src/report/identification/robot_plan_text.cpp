// SPDX-License-Identifier: Apache-2.0
#include "src/report/identification/robot_plan_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace torquewright::report {
namespace {

using identification::FreeValue;
using identification::PlannedValue;
using identification::RobotPlan;
using identification::Room;

std::string value_line(const PlannedValue& each, const std::vector<std::string>& joints) {
  std::string line = fmt::format("  {:44} {:>9.3g} +- {:<9.3g} ({:.3g} by a sweep)",
                                 planned_name(each.by_plan.which, joints), each.by_plan.stated,
                                 each.by_plan.standard_error, each.by_sweep.standard_error);
  if (each.stands_for_it && !each.by_plan.is_told())
    line += fmt::format("; {} may stand for it", planned_name(*each.stands_for_it, joints));
  return line + "\n";
}

std::string value_lines(const RobotPlan& plan, const std::vector<std::string>& joints,
                        bool is_told) {
  std::string lines;
  for (const PlannedValue& each : plan.values) {
    if (each.by_plan.is_told() == is_told) lines += value_line(each, joints);
  }
  return lines;
}

std::string room_text(const RobotPlan& plan) {
  std::string text = "room           ";
  const auto add = [&](const Room& room, double unit, const char* what) {
    if (!std::isfinite(room.left)) return;
    text += fmt::format("{}{:.3g} {} ({})", text.ends_with(' ') ? "" : "; ", room.left * unit, what,
                        room.place);
  };
  add(plan.room.position_rad, 1.0, "rad to a joint's limit");
  add(plan.room.speed_share, 100.0, "% of a joint's speed");
  add(plan.room.torque_share, 100.0, "% of a drive's torque at its speed");
  add(plan.room.bodies_m, 1e3, "mm between bodies");
  add(plan.room.ground_m, 1e3, "mm to the ground");
  return text + "\n";
}

/// What limits nothing because nobody stated it is said; so is what the plan is not for.
std::string left_out_text(const RobotPlan& plan) {
  std::string text =
      "left out       values that all joints share (the base's attitude, the "
      "command's delay)";
  if (!std::isfinite(plan.room.bodies_m.left))
    text += "; whether bodies meet (no two of the robot's collision_spheres could)";
  if (!std::isfinite(plan.room.ground_m.left)) text += "; the ground (no --base-height)";
  return text + "\n";
}

}  // namespace

std::string planned_name(const FreeValue& which, const std::vector<std::string>& joints) {
  return fmt::format("{} {}", joints[which.joint], which.name);
}

std::string robot_plan_text(const RobotPlan& plan, const identification::RobotPlanOptions& options,
                            const std::vector<std::string>& joints, bool is_long) {
  const auto told = std::count_if(plan.values.begin(), plan.values.end(),
                                  [](const PlannedValue& each) { return each.by_plan.is_told(); });
  std::string text = fmt::format(
      "plan           {} runs of {:g} s for {} joints: a log of them would tell {} of {} values\n",
      plan.motions.size(), plan.motions.front().duration_s, joints.size(), told,
      plan.values.size());
  const std::string untold = value_lines(plan, joints, false);
  if (!untold.empty()) {
    text += "not told       by their expected standard errors (docs/logs.md):\n" + untold;
  }
  if (is_long) text += "told\n" + value_lines(plan, joints, true);
  text += room_text(plan) + left_out_text(plan);
  text += fmt::format(
      "assumed        white noise of {:.3g} rad in each position; {} motions were tried, from seed "
      "{}\n",
      options.position_noise_rad, plan.tried, options.seed);
  return text;
}

}  // namespace torquewright::report
