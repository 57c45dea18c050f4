// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hopper/flip/sagittal_robot.hpp"
#include "hopper/motion/motion.hpp"

namespace torquewright::hopper {

/// Within an interval of a phase: `interval` from 0, `share` of it from 0 to 1. Accelerations,
/// torques, forces and voltages are parabolas; velocities and positions their integrals from the
/// interval's begin. docs/derivations/collocation.md eq. (3).
PlannedInstant instant_within(const PlannedPhase& phase, std::size_t interval, double share);

/// A plan as a motion of the robot itself, on its own kind of base: samples at the knots and, so
/// that none are further apart than `sample_s`, between. An impact is two samples at one time;
/// where a stance changes without one, the sample there is the earlier phase's.
Motion sampled_motion(const Robot& robot, const SagittalRobot& plane, const PlannedMotion& plan,
                      double sample_s);

}  // namespace torquewright::hopper
