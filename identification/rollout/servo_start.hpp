// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "identification/log/log.hpp"
#include "identification/rollout/robot_model.hpp"

namespace torquewright::identification {

/// Where a fit of gains that are not known begins: the robot's own inverse dynamics at the measured
/// motion of the runs that may be fitted, per gain, is the command's lead over the position:
///   command(t - delay) - position = (torque of the bodies + J q'' + b q' + c sgn q') / gain +
///   rest.
/// Linear in 1/gain and the ratios J/gain, b/gain, c/gain, so that these are found also where the
/// bodies give no torque and the gain itself is not told; it is then that of the joints where it
/// is, or by the stated inertia of the rotor. Drives have viscous and dry friction
/// (add_plain_friction()). Sets stiffness, delay, rotor and friction of the joints whose stiffness
/// is to be found; others stay.
RobotModel servo_start(const Log& log, const RobotModel& stated);

}  // namespace torquewright::identification
