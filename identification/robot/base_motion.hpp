// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "identification/log/log.hpp"
#include "identification/rollout/robot_model.hpp"

namespace torquewright::identification {

/// What the joints say of a base that is said to be held.
struct BaseMotion {
  /// Of the base's tilt (or the push that does as much) as one half of the limbs shows it with
  /// that of the other half; 0 where there are not two.
  double correlation = 0.0;
  double tilt_rad = 0.0;  ///< Root mean square of what both show.
  double share = 0.0;     ///< Of what is left at all joints that one tilt for all takes.

  bool moves() const;
};

/// A base that sways or is pushed gives each joint the torque that a turn of gravity would. Each
/// half of the limbs tells this turn by itself, from the torques of the joints' laws less those of
/// bodies, rotors and friction; errors of the joints themselves agree by chance only.
BaseMotion base_motion(const Log& log, const RobotModel& fitted);

}  // namespace torquewright::identification
