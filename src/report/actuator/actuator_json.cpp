// SPDX-License-Identifier: Apache-2.0
#include "src/report/actuator/actuator_json.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

namespace torquewright::report {
namespace {

using namespace actuator;
using nlohmann::ordered_json;

ordered_json or_null(const std::optional<double>& value) {
  return value && std::isfinite(*value) ? ordered_json(*value) : ordered_json();
}

}  // namespace

ordered_json need_json(const Need& need, const NeedAnswer& answer) {
  ordered_json range;
  if (!answer.range.is_empty) {
    range = {{"torque_min_Nm", answer.range.least.torque_Nm},
             {"torque_max_Nm", answer.range.greatest.torque_Nm}};
  }
  return {{"kind", "mor_need"},
          {"version", 1},
          {"torque_Nm", need.torque_Nm},
          {"speed_rad_s", need.speed_rad_s},
          {"reached", answer.is_reached},
          {"ended", answer.is_ended},
          {"margin_Nm", or_null(answer.margin_Nm)},
          {"limiter", name_of(answer.limiter)},
          {"region", range},
          {"would_be_reached_with",
           {{"bus_voltage_V", or_null(answer.least_bus_voltage_V)},
            {"current_A", or_null(answer.least_current_A)},
            {"gear_torque_Nm", or_null(answer.least_gear_Nm)},
            {"ratio", or_null(answer.nearest_ratio)}}}};
}

ordered_json sweep_json(const std::vector<RatioRow>& rows) {
  ordered_json list = ordered_json::array();
  for (const RatioRow& row : rows) {
    ordered_json json{{"ratio", row.ratio},
                      {"stall_torque_Nm", row.driving.stall_torque_Nm},
                      {"no_load_speed_rad_s", row.driving.no_load_speed_rad_s},
                      {"greatest_power_W", row.driving.greatest_power_W},
                      {"power_speed_rad_s", row.driving.power_speed_rad_s},
                      {"reflected_inertia_kg_m2", row.reflected_inertia_kg_m2}};
    if (row.margin_Nm) json["margin_Nm"] = or_null(row.margin_Nm);
    list.push_back(json);
  }
  return {{"kind", "mor_ratios"}, {"version", 1}, {"ratios", list}};
}

}  // namespace torquewright::report
