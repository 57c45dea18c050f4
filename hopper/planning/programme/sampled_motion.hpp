// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hopper/motion/motion.hpp"
#include "hopper/planning/plane/sagittal_robot.hpp"

namespace torquewright::hopper {

/// A plan as a motion of the robot itself, on its own kind of base: samples at the knots and, so
/// that none are further apart than `sample_s`, between. An impact is two samples at one time;
/// where a stance changes without one, the sample there is the earlier phase's, and 10 us later
/// comes one of the later.
Motion sampled_motion(const Robot& robot, const SagittalRobot& plane, const PlannedMotion& plan,
                      double sample_s);

}  // namespace torquewright::hopper
