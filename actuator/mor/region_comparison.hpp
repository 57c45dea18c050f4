// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "actuator/region/joint_region.hpp"

namespace torquewright::actuator {

/// Where speed and torque are positive or negative.
struct Quadrant {
  std::string_view name;
  int speed_sign;
  int torque_sign;
};
constexpr std::array<Quadrant, 4> kQuadrants = {{{"driving forward", 1, 1},
                                                 {"braking backward", -1, 1},
                                                 {"driving backward", -1, -1},
                                                 {"braking forward", 1, -1}}};

/// A change of the torque that is to be had in a quadrant, at the speed where it is largest.
struct TorqueChange {
  double change_Nm = 0.0;  ///< Of the magnitude; negative: lost.
  double speed_rad_s = 0.0;
  double from_Nm = 0.0;  ///< Magnitudes, 0 where the region does not reach into the quadrant.
  double to_Nm = 0.0;
};

struct QuadrantComparison {
  TorqueChange worst_loss;  ///< change <= 0.
  TorqueChange best_gain;   ///< change >= 0.
};

/// What a region is asked for first.
struct RegionFigures {
  double peak_torque_Nm = 0.0;       ///< Greatest magnitude of a bound.
  double stall_torque_Nm = 0.0;      ///< Driving, at rest.
  double no_load_speed_rad_s = 0.0;  ///< Up to which it drives forward.
};

struct RegionComparison {
  RegionFigures from, to;
  std::array<QuadrantComparison, 4> quadrants;  ///< In the order of kQuadrants.
  std::optional<double> one_sided_rad_s;  ///< A speed at which one region alone is empty, if any.
};

/// Largest differences between two regions where neither is empty, over speeds dense enough for
/// kComparedSpeeds per direction and all corners of both tables.
RegionComparison compare(const Region& from, const Region& to);
constexpr std::size_t kComparedSpeeds = 400;

}  // namespace torquewright::actuator
