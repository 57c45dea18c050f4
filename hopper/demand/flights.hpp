// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hopper/demand/checked_motion.hpp"

namespace torquewright::hopper {

/// A stretch without contact, and how the robot turns in it.
struct Flight {
  double from_s = 0.0;  ///< Time of its first sample.
  double until_s = 0.0;
  double angular_momentum_Nm_s = 0.0;  ///< Magnitude of CAM, as a mean.
  /// Largest distance of any sample's CAM from the mean.
  double angular_momentum_drift_Nm_s = 0.0;
  double take_off_rad_s = 0.0;  ///< Magnitude of CAV at the first sample.
  double peak_rad_s = 0.0;
  double touch_down_rad_s = 0.0;
  double rise_m = 0.0;                       ///< Rise of the centre of mass over the first sample.
  double angular_momentum_limit_Nm_s = 0.0;  ///< Limit of the drift.
  /// Acceleration of the parabola that fits the path of the centre of mass, world's axes.
  Eigen::Vector3d fall_m_s2 = Eigen::Vector3d::Zero();
  double fall_error_m_s2 = 0.0;  ///< Distance of fall_m_s2 from gravity.
  double fall_limit_m_s2 = 0.0;  ///< Limit of fall_error_m_s2.
};

/// Returns the flights of two samples and more that last as long as options say. In each CAM is
/// constant and the centre of mass falls, whatever the actuators do: drift and wrong fall are the
/// motion's own error. Their limits are in units of the motion, a tenth of what the residual may be
/// over its short window, since a flight averages out what that does not
/// (docs/derivations/whole_body_check.md eqs. (21), (22)).
std::vector<Flight> flights(const CheckedMotion& checked);

}  // namespace torquewright::hopper
