// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "identification/robot_plan/commanded_motion.hpp"
#include "identification/rollout/robot_model.hpp"
#include "robot/model/robot.hpp"

namespace torquewright::identification {

/// What a planned motion of a robot has to stay within, beside the joints' own limits and the
/// regions of their drives.
struct MotionLimits {
  double speed_rad_s = std::numeric_limits<double>::infinity();
  double from_start_rad = std::numeric_limits<double>::infinity();
  /// Height of the base's origin above the ground; nothing: the ground is out of reach.
  std::optional<double> base_height_m;
};

/// The least that a motion leaves of something, and where.
struct Room {
  double left = std::numeric_limits<double>::infinity();
  std::string place;  ///< A joint, a point, or two bodies.
};

/// What a motion leaves of everything that limits it.
struct MotionRoom {
  Room position_rad;  ///< To a joint's limit.
  Room speed_share;   ///< Of a joint's greatest speed that is not used.
  Room torque_share;  ///< Of what a drive's region gives at its speed.
  Room bodies_m;      ///< Between spheres of bodies that no joint joins.
  Room ground_m;      ///< Below spheres and points that may touch.
};

/// What the simulated motion of a robot leaves, and which of its joints go too far: those whose
/// reach is to be less.
struct RoomOfMotion {
  MotionRoom room;
  std::vector<bool> goes_too_far;  ///< By joint, in the rig's order.
};

/// Simulates the robot under its own loops along a motion. Spheres and contacts are those of
/// `robot`, which the model's load was made of. Throws io::SpecError where the simulation grows
/// without bound.
RoomOfMotion room_of(const RobotModel& model, const hopper::Robot& robot,
                     const MotionLimits& limits, const CommandedMotion& motion);

}  // namespace torquewright::identification
