// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "actuator/region/joint_region.hpp"

namespace torquewright::actuator {

/// What a region has of torque that drives, one way: the first numbers that one asks for.
struct DrivingFigures {
  double stall_torque_Nm = 0.0;      ///< Greatest driving torque at rest.
  double no_load_speed_rad_s = 0.0;  ///< Highest speed at which some torque still drives.
  double greatest_power_W = 0.0;     ///< Mechanical.
  double power_speed_rad_s = 0.0;    ///< Where it is.
};

/// Torques and speeds that drive with `direction` (1 or -1), as magnitudes.
DrivingFigures driving_figures(const Region& region, double direction = 1.0);

/// Speeds over which one thing ends the driving torque.
struct LimitedStretch {
  Limiter limiter = Limiter::kCurrent;
  double from_rad_s = 0.0;
  double to_rad_s = 0.0;
  double last_torque_Nm = 0.0;  ///< At its end.
};

/// From rest to the no-load speed, in order; each is of another limiter than the one before.
std::vector<LimitedStretch> limited_stretches(const Region& region, double direction = 1.0);

}  // namespace torquewright::actuator
