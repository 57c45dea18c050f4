// SPDX-License-Identifier: Apache-2.0
#include "src/report/identification/robot_plan_json.hpp"

#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

namespace torquewright::report {
namespace {

using identification::FreeValue;
using identification::PlannedValue;
using identification::RobotPlan;
using identification::Room;
using nlohmann::ordered_json;

ordered_json name_json(const FreeValue& which, const std::vector<std::string>& joints) {
  ordered_json entry = {{"joint", joints[which.joint]}};
  if (!which.effect.empty()) entry["effect"] = which.effect;
  entry["name"] = which.name;
  return entry;
}

ordered_json value_json(const PlannedValue& each, const std::vector<std::string>& joints) {
  ordered_json entry = name_json(each.by_plan.which, joints);
  entry["stated"] = each.by_plan.stated;
  entry["told"] = each.by_plan.is_told();
  entry["standard_error"] = {{"plan", each.by_plan.standard_error},
                             {"sweep", each.by_sweep.standard_error}};
  if (each.stands_for_it) entry["stands_for_it"] = name_json(*each.stands_for_it, joints);
  return entry;
}

void add_room(ordered_json& all, const char* name, const Room& room) {
  if (!std::isfinite(room.left)) return;
  all[name] = {{"left", room.left}, {"at", room.place}};
}

}  // namespace

ordered_json robot_plan_json(const RobotPlan& plan, const identification::RobotPlanOptions& options,
                             const std::vector<std::string>& joints, ordered_json stated) {
  ordered_json document;
  document["separable"] = plan.tells_all();
  document["values"] = ordered_json::array();
  for (const PlannedValue& each : plan.values)
    document["values"].push_back(value_json(each, joints));
  document["room"] = ordered_json::object();
  add_room(document["room"], "position_rad", plan.room.position_rad);
  add_room(document["room"], "speed_share", plan.room.speed_share);
  add_room(document["room"], "torque_share", plan.room.torque_share);
  add_room(document["room"], "bodies_m", plan.room.bodies_m);
  add_room(document["room"], "ground_m", plan.room.ground_m);
  document["noise"] = {{"output_position_rad", options.position_noise_rad}};
  document["tried"] = plan.tried;
  document["options"] = std::move(stated);
  return document;
}

}  // namespace torquewright::report
