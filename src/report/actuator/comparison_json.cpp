// SPDX-License-Identifier: Apache-2.0
#include "src/report/actuator/comparison_json.hpp"

#include <nlohmann/json.hpp>

namespace torquewright::report {
namespace {

using namespace actuator;
using nlohmann::ordered_json;

ordered_json figures_json(const RegionFigures& figures) {
  return {{"peak_torque_Nm", figures.peak_torque_Nm},
          {"stall_torque_Nm", figures.stall_torque_Nm},
          {"no_load_speed_rad_s", figures.no_load_speed_rad_s}};
}

ordered_json change_json(const TorqueChange& change) {
  return {{"change_Nm", change.change_Nm},
          {"speed_rad_s", change.speed_rad_s},
          {"from_Nm", change.from_Nm},
          {"to_Nm", change.to_Nm}};
}

}  // namespace

ordered_json comparison_json(const std::string& from, const std::string& to,
                             const RegionComparison& comparison, Side side) {
  ordered_json quadrants = ordered_json::array();
  for (std::size_t q = 0; q < kQuadrants.size(); ++q) {
    quadrants.push_back({{"name", kQuadrants[q].name},
                         {"worst_loss", change_json(comparison.quadrants[q].worst_loss)},
                         {"best_gain", change_json(comparison.quadrants[q].best_gain)}});
  }
  return {{"kind", "region_comparison"},
          {"version", 1},
          {"from", {{"name", from}, {"figures", figures_json(comparison.from)}}},
          {"to", {{"name", to}, {"figures", figures_json(comparison.to)}}},
          {"quadrants", quadrants},
          {"one_sided_speed_rad_s",
           comparison.one_sided_rad_s ? ordered_json(*comparison.one_sided_rad_s) : ordered_json()},
          {"side", side == Side::kJoint ? "joint" : "motor"}};
}

}  // namespace torquewright::report
