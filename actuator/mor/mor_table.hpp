// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "actuator/region/joint_region.hpp"

namespace torquewright::actuator {

/// What a region allows at a speed.
struct MorRow {
  double speed_rad_s = 0.0;
  JointRange range;
};

/// The region as rows of ascending speed, to be interpolated linearly. Every corner has a row;
/// where a bound jumps at rest there are two rows at speed 0, the limit from below first.
struct MorTable {
  std::vector<MorRow> rows;
  double peak_torque_Nm = 0.0;          ///< Greatest magnitude of a bound.
  double interpolation_error_Nm = 0.0;  ///< Greatest found between rows, at three points each.
};

/// The part of the peak torque within which linear interpolation stays, if nothing else is asked.
constexpr double kTableAccuracy = 2.5e-4;
constexpr double kFinestTableAccuracy = 1e-8;  ///< Some 10,000 rows.

/// The whole region, from the greatest negative speed to the greatest positive one.
/// docs/derivations/motor_region.md section 6.
MorTable mor_table(const Region& region, double accuracy = kTableAccuracy);

/// Single rows, in the order asked for; empty ranges where the region ends.
MorTable mor_rows(const Region& region, const std::vector<double>& speeds_rad_s);

}  // namespace torquewright::actuator
