// SPDX-License-Identifier: Apache-2.0
#include "actuator/mor/region_comparison.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "actuator/mor/mor_table.hpp"
#include "actuator/region/bracketed_search.hpp"

namespace torquewright::actuator {
namespace {

constexpr double kSpeedTolerance = 1e-6;

bool is_empty(const Region& region, const Quadrant& quadrant, double speed_rad_s) {
  return region.at(quadrant.speed_sign * speed_rad_s, static_cast<double>(quadrant.speed_sign))
      .is_empty;
}

/// Magnitude of the torque in the quadrant, at a speed >= 0 of its direction.
double torque_Nm(const Region& region, const Quadrant& quadrant, double speed_rad_s) {
  const JointRange range =
      region.at(quadrant.speed_sign * speed_rad_s, static_cast<double>(quadrant.speed_sign));
  if (range.is_empty) return 0.0;
  const double bound_Nm =
      quadrant.torque_sign > 0 ? range.greatest.torque_Nm : range.least.torque_Nm;
  return std::max(0.0, quadrant.torque_sign * bound_Nm);
}

/// Magnitudes of the speeds at which regions are compared, 0 first.
std::vector<double> compared_speeds(const Region& from, const Region& to) {
  const double last_rad_s = std::max(from.greatest_speed_rad_s(), to.greatest_speed_rad_s());
  std::vector<double> speeds{0.0};
  for (std::size_t i = 1; i <= kComparedSpeeds; ++i) {
    speeds.push_back(last_rad_s * static_cast<double>(i) / static_cast<double>(kComparedSpeeds));
  }
  // The corners: there differences are largest.
  for (const Region* region : {&from, &to}) {
    for (const MorRow& row : mor_table(*region).rows) speeds.push_back(std::abs(row.speed_rad_s));
  }
  std::sort(speeds.begin(), speeds.end());
  return speeds;
}

RegionFigures figures_of(const Region& region) {
  RegionFigures figures;
  const Quadrant& driving = kQuadrants[0];
  figures.peak_torque_Nm = mor_table(region).peak_torque_Nm;
  figures.stall_torque_Nm = torque_Nm(region, driving, 0.0);
  const double end_rad_s = region.greatest_speed_rad_s();
  const auto drives = [&](double speed_rad_s) {
    return torque_Nm(region, driving, speed_rad_s) > 0.0 ? 1.0 : -1.0;
  };
  if (figures.stall_torque_Nm <= 0.0) return figures;
  figures.no_load_speed_rad_s =
      drives(end_rad_s) > 0.0
          ? end_rad_s
          : last_nonnegative(drives, 0.0, end_rad_s, kSpeedTolerance * end_rad_s);
  return figures;
}

}  // namespace

RegionComparison compare(const Region& from, const Region& to) {
  RegionComparison comparison{figures_of(from), figures_of(to), {}, {}};
  const std::vector<double> speeds = compared_speeds(from, to);
  for (std::size_t q = 0; q < kQuadrants.size(); ++q) {
    QuadrantComparison& result = comparison.quadrants[q];
    for (const double speed_rad_s : speeds) {
      TorqueChange here;
      here.speed_rad_s = kQuadrants[q].speed_sign * speed_rad_s + 0.0;  // no -0
      // Where one region is empty there is nothing to hold at all, neither lost nor won torque.
      const bool is_from_empty = is_empty(from, kQuadrants[q], speed_rad_s);
      const bool is_to_empty = is_empty(to, kQuadrants[q], speed_rad_s);
      if (is_from_empty != is_to_empty && !comparison.one_sided_rad_s) {
        comparison.one_sided_rad_s = here.speed_rad_s;
      }
      if (is_from_empty || is_to_empty) continue;
      here.from_Nm = torque_Nm(from, kQuadrants[q], speed_rad_s);
      here.to_Nm = torque_Nm(to, kQuadrants[q], speed_rad_s);
      here.change_Nm = here.to_Nm - here.from_Nm;
      if (here.change_Nm < result.worst_loss.change_Nm) result.worst_loss = here;
      if (here.change_Nm > result.best_gain.change_Nm) result.best_gain = here;
    }
  }
  return comparison;
}

}  // namespace torquewright::actuator
