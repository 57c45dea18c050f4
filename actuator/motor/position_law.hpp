// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <limits>

namespace torquewright::actuator {

/// The law by which a joint's own controller makes a torque of a commanded position.
struct PositionLaw {
  double stiffness_Nm_rad = 0.0;
  double damping_Nm_s_rad = 0.0;
  double torque_limit_Nm = std::numeric_limits<double>::infinity();

  /// Torque at the output: stiffness (command - position) - damping speed, cut at the limit.
  double torque_Nm(double command_rad, double position_rad, double speed_rad_s) const {
    const double asked_Nm =
        stiffness_Nm_rad * (command_rad - position_rad) - damping_Nm_s_rad * speed_rad_s;
    return std::clamp(asked_Nm, -torque_limit_Nm, torque_limit_Nm);
  }
};

}  // namespace torquewright::actuator
