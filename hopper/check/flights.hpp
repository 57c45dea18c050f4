// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hopper/check/checked_motion.hpp"

namespace torquewright::hopper {

/// A stretch without contact, and how the robot turns in it.
struct Flight {
  double from_s = 0.0;  ///< Its first sample.
  double until_s = 0.0;
  double angular_momentum_Nm_s = 0.0;        ///< CAM's mean, in size.
  double angular_momentum_drift_Nm_s = 0.0;  ///< Farthest of any sample from the mean.
  double take_off_rad_s = 0.0;               ///< CAV in size at the first sample.
  double peak_rad_s = 0.0;
  double touch_down_rad_s = 0.0;
  double rise_m = 0.0;  ///< Of the centre of mass over the first sample.
};

/// Those of two samples and more. CAM is constant in each, whatever the actuators do: its drift is
/// the motion's own error.
std::vector<Flight> flights(const CheckedMotion& checked);

}  // namespace torquewright::hopper
