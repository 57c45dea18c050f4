// SPDX-License-Identifier: Apache-2.0
#include "src/report/actuator/shortlist_json.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

namespace torquewright::report {
namespace {

using nlohmann::ordered_json;

ordered_json or_null(const std::optional<double>& value) {
  return value && std::isfinite(*value) ? ordered_json(*value) : ordered_json();
}

}  // namespace

ordered_json shortlist_json(const actuator::Wanted& wanted, const std::vector<RankedDrive>& drives,
                            const std::vector<std::string>& left_out) {
  ordered_json needs = ordered_json::array();
  for (const actuator::Need& need : wanted.needs) {
    needs.push_back({{"torque_Nm", need.torque_Nm}, {"speed_rad_s", need.speed_rad_s}});
  }
  ordered_json list = ordered_json::array();
  for (const RankedDrive& one : drives) {
    list.push_back({{"drive", one.drive->stem},
                    {"name", one.drive->actuator.name},
                    {"fits", one.suitability.fits},
                    {"unknown", one.suitability.is_unknown},
                    {"margin_share", or_null(one.suitability.margin_share)},
                    {"mass_kg", or_null(one.drive->actuator.mass_kg)},
                    {"ratio", one.suitability.ratio},
                    {"reasons", one.suitability.reasons}});
  }
  return {{"kind", "drive_shortlist"},
          {"version", 1},
          {"needs", needs},
          {"continuous_torque_Nm", or_null(wanted.continuous_Nm)},
          {"mass_below_kg", or_null(wanted.mass_below_kg)},
          {"drives", list},
          {"left_out", left_out}};
}

}  // namespace torquewright::report
