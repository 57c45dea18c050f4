// SPDX-License-Identifier: Apache-2.0
#include "src/report/actuator/shortlist.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace torquewright::report {
namespace {

using nlohmann::ordered_json;

ordered_json or_null(const std::optional<double>& value) {
  return value && std::isfinite(*value) ? ordered_json(*value) : ordered_json();
}

std::string margin_text(const std::optional<double>& share) {
  if (!share) return "unknown";
  if (!std::isfinite(*share)) return "any";
  return fmt::format("{:+.0f} %", 100.0 * *share);
}

std::string mass_text(const std::optional<double>& mass_kg) {
  return mass_kg ? fmt::format("{:.3g}", *mass_kg) : "-";
}

/// As wide as the widest of them.
std::size_t width_of_names(const std::vector<RankedDrive>& drives) {
  std::size_t width = 5;
  for (const RankedDrive& one : drives) width = std::max(width, one.drive->stem.size());
  return width;
}

}  // namespace

std::string shortlist_text(const std::vector<RankedDrive>& drives,
                           const std::vector<std::string>& left_out) {
  const auto fit = std::count_if(drives.begin(), drives.end(),
                                 [](const RankedDrive& one) { return one.suitability.fits; });
  const auto unknown = std::count_if(drives.begin(), drives.end(), [](const RankedDrive& one) {
    return one.suitability.is_unknown;
  });
  std::string text = fmt::format("{} of {} drives fit", fit, drives.size());
  if (unknown > 0) text += fmt::format(", {} would if what they do not state does", unknown);
  text += "\n";
  const std::size_t width = width_of_names(drives);
  text += fmt::format("  {:<{}}  {:>8}  {:>6}  {:>7}  {}\n", "drive", width, "margin", "kg",
                      "ratio", "why not");
  for (const RankedDrive& one : drives) {
    text += fmt::format("  {:<{}}  {:>8}  {:>6}  {:>7.4g}  {}", one.drive->stem, width,
                        margin_text(one.suitability.margin_share),
                        mass_text(one.drive->actuator.mass_kg), one.suitability.ratio,
                        fmt::join(one.suitability.reasons, "; "));
    text.erase(text.find_last_not_of(' ') + 1);
    text += "\n";
  }
  for (const std::string& sentence : left_out) text += fmt::format("left out: {}\n", sentence);
  return text;
}

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
