// SPDX-License-Identifier: Apache-2.0
#include "actuator/mor/mor_table_spec.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "actuator/region/left_out.hpp"
#include "io/text/number_text.hpp"

namespace torquewright::actuator {
namespace {

using nlohmann::ordered_json;

/// Every effect with where it is from: "coulomb_friction (identified)".
std::vector<std::string> effects_and_sources(const Actuator& actuator) {
  std::vector<std::string> list;
  for (const Effect& effect : actuator.effects) {
    list.push_back(effect.provenance.empty()
                       ? std::string(effect.kind->name)
                       : fmt::format("{} ({})", effect.kind->name, effect.provenance));
  }
  return list;
}

/// Fourteen digits: what is beyond is the rounding of conversions between conventions, and would
/// show 320 as 319.99999999999994.
double rounded(double value) {
  const double result = std::strtod(fmt::format("{:.14g}", value).c_str(), nullptr);
  return result == 0.0 ? 0.0 : result;  // not -0
}

ordered_json number_or_null(bool is_there, double value) {
  return is_there ? ordered_json(rounded(value)) : ordered_json();
}

ordered_json row_json(const MorRow& row, bool has_winding) {
  const JointRange& range = row.range;
  const bool is_there = !range.is_empty;
  const bool has_current = is_there && has_winding;
  const Limiter least = is_there ? range.least.limiter : range.why_empty;
  const Limiter greatest = is_there ? range.greatest.limiter : range.why_empty;
  ordered_json entry{
      {"speed_rad_s", rounded(row.speed_rad_s)},
      {"torque_min_Nm", number_or_null(is_there, range.least.torque_Nm)},
      {"torque_max_Nm", number_or_null(is_there, range.greatest.torque_Nm)},
      {"current_min_A", number_or_null(has_current, range.least.current_A)},
      {"current_max_A", number_or_null(has_current, range.greatest.current_A)},
      {"bus_power_at_min_W", number_or_null(has_current, range.least.bus_power_W)},
      {"bus_power_at_max_W", number_or_null(has_current, range.greatest.bus_power_W)},
      {"limiter_min", name_of(least)},
      {"limiter_max", name_of(greatest)}};
  if (range.plugging) {
    entry["plugging"] = {{"torque_min_Nm", rounded(range.plugging->least_Nm)},
                         {"torque_max_Nm", rounded(range.plugging->greatest_Nm)}};
  }
  return entry;
}

/// Null where it is not known.
template <typename Value>
ordered_json either(bool is_known, const Value& value) {
  return is_known ? ordered_json(value) : ordered_json();
}

/// The greatest magnitude of each column of numbers, by which its digits are known.
std::map<std::string, double> scales_of(const ordered_json& rows) {
  std::map<std::string, double> scales;
  for (const ordered_json& row : rows) {
    for (const auto& item : row.items()) {
      if (!item.value().is_number()) continue;
      double& scale = scales[item.key()];
      scale = std::max(scale, std::abs(item.value().get<double>()));
    }
  }
  return scales;
}

std::string cell(const ordered_json& value, double scale) {
  if (value.is_null()) return "";
  return value.is_string() ? value.get<std::string>() : io::known_text(value.get<double>(), scale);
}

std::string line_of(const ordered_json& row, const std::map<std::string, double>& scales) {
  std::string line;
  for (const auto& item : row.items()) {
    if (item.key() == "plugging") continue;
    const auto scale = scales.find(item.key());
    line += line.empty() ? "" : ",";
    line += cell(item.value(), scale == scales.end() ? 0.0 : scale->second);
  }
  return line + "\n";
}

/// Rows that are one but for what rounding left, on both sides of a corner, are one line.
std::string lines_of(const ordered_json& rows) {
  const std::map<std::string, double> scales = scales_of(rows);
  std::string text, last;
  for (const ordered_json& row : rows) {
    const std::string line = line_of(row, scales);
    if (line != last) text += line;
    last = line;
  }
  return text;
}

}  // namespace

ordered_json mor_table_json(const MorHeader& header, const MorTable& table) {
  const Actuator& actuator = *header.actuator;
  const bool has_winding = !actuator.envelope;
  const bool has_voltage = has_winding || actuator.envelope->voltage_V;
  ordered_json rows = ordered_json::array();
  for (const MorRow& row : table.rows) rows.push_back(row_json(row, has_winding));
  return {
      {"kind", "mor_table"},
      {"version", 1},
      {"name", actuator.name},
      {"side", name_of(header.side)},
      {"rating", name_of(header.conditions.rating)},
      {"bus_voltage_V", either(has_voltage, open_circuit_voltage_V(actuator, header.conditions))},
      {"winding_temperature_K",
       either(has_winding, winding_temperature_K(actuator, header.conditions))},
      {"current_convention",
       either(has_winding, name_of(actuator.motor.torque_constant_convention))},
      {"friction_included", friction_sentence(header)},
      {"effects", effects_and_sources(actuator)},
      {"interpolation_error_Nm", table.interpolation_error_Nm},
      {"left_out", left_out(actuator, Part::kRegion)},
      {"assumed", actuator.assumed},
      {"rows", rows}};
}

std::string mor_table_csv(const MorHeader& header, const MorTable& table) {
  ordered_json document = mor_table_json(header, table);
  document["interpolation_error_Nm"] =
      io::known(table.interpolation_error_Nm, table.peak_torque_Nm);
  std::string text;
  for (const auto& item : document.items()) {
    if (item.key() == "rows" || item.key() == "kind" || item.key() == "version") continue;
    if (!item.value().is_array()) {
      text += fmt::format(
          "# {}: {}\n", item.key(),
          item.value().is_string() ? item.value().get<std::string>() : item.value().dump());
      continue;
    }
    for (const auto& entry : item.value()) {
      text += fmt::format("# {}: {}\n", item.key(), entry.get<std::string>());
    }
  }
  text +=
      "speed_rad_s,torque_min_Nm,torque_max_Nm,current_min_A,current_max_A,bus_power_at_min_W,"
      "bus_power_at_max_W,limiter_min,limiter_max\n";
  return text + lines_of(document["rows"]);
}

}  // namespace torquewright::actuator
