// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "actuator/mor/region_summary.hpp"
#include "actuator/region/joint_region.hpp"

namespace torquewright::actuator {

/// A torque that must be there at a speed, at the joint.
struct Need {
  double torque_Nm = 0.0;
  double speed_rad_s = 0.0;
};

/// Does the actuator reach it? If not: what alone would, each the least change, everything else as
/// it is; empty where no change up to kGreatestChange does.
struct NeedAnswer {
  bool is_reached = false;
  double margin_Nm = 0.0;  ///< To the nearer bound; negative: so much is missing.
  Limiter limiter = Limiter::kVoltage;
  JointRange range;
  std::optional<double> least_bus_voltage_V;
  std::optional<double> least_current_A;  ///< Of the rating, in the document's convention.
  std::optional<double> least_gear_Nm;    ///< What the gears would have to carry, at the joint.
  std::optional<double> nearest_ratio;
  bool is_ended = false;  ///< By should_stop: what is empty above may not have been looked for.
};
constexpr double kGreatestChange = 10.0;  ///< Factor on voltage, current or ratio.

/// Requires that there are no objections to the conditions.
NeedAnswer answer_need(
    const Actuator& actuator, const OperatingConditions& conditions, const Need& need,
    const std::function<bool()>& should_stop = [] { return false; });

/// What one ratio would make of the same motor, drive and losses.
struct RatioRow {
  double ratio = 0.0;
  DrivingFigures driving;
  double reflected_inertia_kg_m2 = 0.0;
  std::optional<double> margin_Nm;  ///< At the need, if one was given.
};

/// `count` ratios from `low` to `high`, evenly spaced in their logarithm. The sign is the present
/// ratio's. Requires 0 < low <= high and count >= 1.
std::vector<RatioRow> ratio_sweep(const Actuator& actuator, const OperatingConditions& conditions,
                                  double low, double high, std::size_t count,
                                  const std::optional<Need>& need);

}  // namespace torquewright::actuator
