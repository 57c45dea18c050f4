// SPDX-License-Identifier: Apache-2.0
#include "actuator/exporters/region_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "io/text/number_text.hpp"

namespace torquewright::actuator {

ExportedConditions exported_conditions(const Subject& subject) {
  if (subject.actuator.envelope) return {};
  std::optional<RegionGrid> grid =
      region_grid(subject.actuator, subject.conditions, subject.region.side());
  if (!grid) return {};
  const std::optional<WindingLine> line = winding_line(*grid);
  if (subject.fit == LawFit::kBest) return {grid, line};
  // Each condition by what the cells about it are off, so that within each the mixture is drawn in
  // by no less than its error.
  for (std::size_t condition = 0; condition < grid->least.torques_Nm.size(); ++condition) {
    const double error_Nm = error_about_Nm(*grid, condition);
    for (double& torque_Nm : grid->least.torques_Nm[condition]) torque_Nm += error_Nm;
    for (double& torque_Nm : grid->greatest.torques_Nm[condition]) torque_Nm -= error_Nm;
  }
  return {grid, line};
}

std::optional<RegionGrid> exported_grid(const Subject& subject) {
  return exported_conditions(subject).grid;
}

std::vector<std::string> grid_lines(const std::optional<RegionGrid>& grid) {
  if (!grid) {
    return {"Over voltage and temperature: no grid, the region has a gap; one condition per file."};
  }
  std::vector<std::string> lines{fmt::format(
      "Over voltage and temperature: {:.6g} to {:.6g} V without load ({} values), {:.6g} to {:.6g} "
      "K ({} values); beyond them the nearest holds.",
      grid->voltages_V.front(), grid->voltages_V.back(), grid->voltages_V.size(),
      grid->temperatures_K.front(), grid->temperatures_K.back(), grid->temperatures_K.size())};
  lines.push_back(fmt::format(
      "Between them the bounds are off by {:.3g} Nm at most up to {:.2g} of the greatest speed, by "
      "{:.3g} Nm over all speeds (at {:.6g} rad/s).",
      grid->error_before_end_Nm, RegionGrid::kBeforeEnd, grid->error_Nm, grid->error_speed_rad_s));
  return lines;
}

double greatest_torque_Nm(const Subject& subject, const std::optional<RegionGrid>& grid) {
  double greatest_Nm = subject.table.peak_torque_Nm;
  if (!grid) return greatest_Nm;
  for (const GridBound* bound : {&grid->least, &grid->greatest}) {
    for (const std::vector<double>& torques_Nm : bound->torques_Nm) {
      for (const double torque_Nm : torques_Nm) {
        greatest_Nm = std::max(greatest_Nm, std::abs(torque_Nm));
      }
    }
  }
  return greatest_Nm;
}

std::size_t rest_place(const GridBound& bound) {
  const auto place =
      std::find(bound.places.begin(), bound.places.end(), static_cast<double>(bound.rest_corner));
  return static_cast<std::size_t>(place - bound.places.begin());
}

std::string number_lines(std::span<const double> values, std::string_view indent, bool is_rounded) {
  const std::size_t kPerLine = is_rounded ? 8 : 4;
  std::string text;
  for (std::size_t i = 0; i < values.size(); ++i) {
    text += i % kPerLine == 0 ? std::string(indent) : " ";
    text += is_rounded ? fmt::format("{:.10g}", values[i]) : io::precise_text(values[i]);
    text += i % kPerLine == kPerLine - 1 || i + 1 == values.size() ? ",\n" : ",";
  }
  return text;
}

}  // namespace torquewright::actuator
