// SPDX-License-Identifier: Apache-2.0
#include "actuator/mor/region_summary.hpp"

#include <algorithm>
#include <cmath>

#include "actuator/mor/mor_table.hpp"
#include "actuator/region/bracketed_search.hpp"

namespace torquewright::actuator {
namespace {

constexpr double kSpeedTolerance = 1e-9;  // of the region's end
constexpr double kPowerTolerance = 1e-6;  // of the region's end

double driving_Nm(const Region& region, double direction, double speed_rad_s) {
  const JointRange range = region.at(direction * speed_rad_s, direction);
  if (range.is_empty) return 0.0;
  const JointBound& bound = direction > 0.0 ? range.greatest : range.least;
  return std::max(0.0, direction * bound.torque_Nm);
}

double no_load_speed_rad_s(const Region& region, double direction) {
  const double end_rad_s = region.greatest_speed_rad_s();
  const auto drives = [&](double speed_rad_s) {
    return driving_Nm(region, direction, speed_rad_s) > 0.0 ? 1.0 : -1.0;
  };
  if (drives(0.0) < 0.0) return 0.0;
  if (drives(end_rad_s) > 0.0) return end_rad_s;
  return last_nonnegative(drives, 0.0, end_rad_s, kSpeedTolerance * end_rad_s);
}

}  // namespace

DrivingFigures driving_figures(const Region& region, double direction) {
  DrivingFigures figures;
  figures.stall_torque_Nm = driving_Nm(region, direction, 0.0);
  figures.no_load_speed_rad_s = no_load_speed_rad_s(region, direction);
  const auto power_W = [&](double speed_rad_s) {
    return speed_rad_s * driving_Nm(region, direction, speed_rad_s);
  };
  figures.power_speed_rad_s = greatest_point(power_W, 0.0, figures.no_load_speed_rad_s,
                                             kPowerTolerance * region.greatest_speed_rad_s());
  figures.greatest_power_W = power_W(figures.power_speed_rad_s);
  return figures;
}

std::vector<LimitedStretch> limited_stretches(const Region& region, double direction) {
  const double end_rad_s = no_load_speed_rad_s(region, direction);
  std::vector<LimitedStretch> found;
  const auto add = [&](const MorRow& row) {
    const double speed_rad_s = direction * row.speed_rad_s;
    if (row.range.is_empty || speed_rad_s < 0.0 || speed_rad_s > end_rad_s) return;
    const Limiter limiter = direction > 0.0 ? row.range.greatest.limiter : row.range.least.limiter;
    if (!found.empty()) found.back().to_rad_s = speed_rad_s;
    if (found.empty() || found.back().limiter != limiter) {
      found.push_back({limiter, speed_rad_s, speed_rad_s});
    }
  };
  const std::vector<MorRow> rows = mor_table(region).rows;
  if (direction > 0.0) {
    std::for_each(rows.begin(), rows.end(), add);
  } else {
    std::for_each(rows.rbegin(), rows.rend(), add);
  }
  if (!found.empty()) found.back().to_rad_s = end_rad_s;
  std::erase_if(found, [&](const LimitedStretch& one) {
    return one.to_rad_s - one.from_rad_s <= kPowerTolerance * end_rad_s;
  });
  for (LimitedStretch& one : found) {
    one.last_torque_Nm = driving_Nm(region, direction, one.to_rad_s);
  }
  return found;
}

}  // namespace torquewright::actuator
