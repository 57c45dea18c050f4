// SPDX-License-Identifier: Apache-2.0
#include "actuator/conditions/winding_line.hpp"

#include <algorithm>
#include <cmath>

namespace torquewright::actuator {
namespace {

constexpr double kOnLine = 1e-9;  // of the greatest torque: roundings of corners that are searched

double speed_rad_s(const std::vector<double>& corners_rad_s, double place) {
  const auto last = static_cast<double>(corners_rad_s.size() - 2);
  const double corner = std::clamp(std::floor(place), 0.0, last);
  const auto i = static_cast<std::size_t>(corner);
  return std::lerp(corners_rad_s[i], corners_rad_s[i + 1], place - corner);
}

/// Where the greatest bound falls under one condition: its slope, and the speed without torque.
struct Fall {
  double slope_Nm_s_rad;
  double no_load_rad_s;
};

std::optional<Fall> fall_of(const GridBound& bound, std::size_t condition) {
  const std::vector<double>& torques_Nm = bound.torques_Nm[condition];
  const std::vector<double>& corners_rad_s = bound.corners_rad_s[condition];
  std::optional<Fall> widest;
  double most_Nm = 0.0;
  for (std::size_t i = 0; i + 1 < torques_Nm.size(); ++i) {
    const double before_rad_s = speed_rad_s(corners_rad_s, bound.places[i]);
    const double width_rad_s = speed_rad_s(corners_rad_s, bound.places[i + 1]) - before_rad_s;
    const double fall_Nm = torques_Nm[i] - torques_Nm[i + 1];
    if (!(width_rad_s > 0.0) || !(fall_Nm > most_Nm)) continue;
    const double slope_Nm_s_rad = fall_Nm / width_rad_s;
    widest = Fall{slope_Nm_s_rad, before_rad_s + torques_Nm[i] / slope_Nm_s_rad};
    most_Nm = fall_Nm;
  }
  return widest;
}

double greatest_of(const RegionGrid& grid) {
  double greatest_Nm = 0.0;
  for (const std::vector<double>& torques_Nm : grid.greatest.torques_Nm) {
    greatest_Nm = std::max(greatest_Nm, *std::max_element(torques_Nm.begin(), torques_Nm.end()));
  }
  return greatest_Nm;
}

/// Whether every torque of a bound is that of the line, where `sign` is that of its voltage.
bool holds(const WindingLine& line, const RegionGrid& grid, const GridBound& bound, double sign) {
  for (std::size_t condition = 0; condition < bound.torques_Nm.size(); ++condition) {
    const double voltage_V = grid.voltages_V[condition / grid.temperatures_K.size()];
    const double warmer_K = grid.temperatures_K[condition % grid.temperatures_K.size()] - line.at_K;
    for (std::size_t i = 0; i < bound.places.size(); ++i) {
      const double at_rad_s = speed_rad_s(bound.corners_rad_s[condition], bound.places[i]);
      const double free_Nm = line.torque_Nm_V / (1.0 + line.per_K * warmer_K) *
                             (sign * voltage_V - line.V_s_rad * at_rad_s);
      const double torque_Nm = std::clamp(free_Nm, -line.greatest_Nm, line.greatest_Nm);
      const double off_Nm = std::abs(bound.torques_Nm[condition][i] - torque_Nm);
      if (!(off_Nm <= kOnLine * line.greatest_Nm)) return false;
    }
  }
  return true;
}

}  // namespace

std::optional<WindingLine> winding_line(const RegionGrid& grid) {
  const std::size_t last = grid.temperatures_K.size() - 1;
  const std::optional<Fall> cold = fall_of(grid.greatest, 0);
  const std::optional<Fall> warm = fall_of(grid.greatest, last);
  if (!cold || !warm || !(cold->no_load_rad_s > 0.0)) return std::nullopt;
  WindingLine line;
  line.V_s_rad = grid.voltages_V.front() / cold->no_load_rad_s;
  line.torque_Nm_V = cold->slope_Nm_s_rad / line.V_s_rad;
  line.greatest_Nm = greatest_of(grid);
  line.at_K = grid.temperatures_K.front();
  if (last > 0) {
    line.per_K = (cold->slope_Nm_s_rad / warm->slope_Nm_s_rad - 1.0) /
                 (grid.temperatures_K.back() - line.at_K);
  }
  const bool is_line = holds(line, grid, grid.least, -1.0) && holds(line, grid, grid.greatest, 1.0);
  return is_line ? std::optional(line) : std::nullopt;
}

}  // namespace torquewright::actuator
