// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tinyxml2.h>

#include <optional>
#include <string>
#include <vector>

#include "actuator/friction/joint_friction.hpp"
#include "actuator/motor/servo_gains.hpp"
#include "robot/model/robot.hpp"

namespace torquewright::hopper {

/// A drive as `actuator mor --format mujoco` writes its region, and how it turns with joints.
struct Drive {
  std::string name;
  double stall_torque_Nm = 0;
  double no_load_speed_rad_s = 0;
  double greatest_torque_Nm = 0;
  double bus_V = 0;
  bool is_curve = false;             ///< Known by its curve alone: its control is a torque.
  actuator::JointFriction friction;  ///< Beside the region, at the drive's own output.
  std::vector<std::size_t> joints;
  std::vector<double> ratios;  ///< Its speed over each joint's.
  /// What it weighs at its own output, in kg m2: rotor, gears and crank.
  double inertia_kg_m2 = 0;
  std::optional<actuator::ServoGains> gains;  ///< It is told an angle, and has these there.
};

/// Every drive of the robot; ratios are those of the posture nearest to zero, and a note says where
/// they change. `friction` at the joint: beside the region of every drive whose gear does not lock
/// itself, and a note says what MuJoCo cannot hold of it. Of servos (make_servos()) no note speaks
/// of other controls. Throws io::SpecError where a drive has no region.
std::vector<Drive> drives_of(const Robot& robot, actuator::FrictionPlace friction, bool is_servo,
                             std::vector<std::string>& notes);

/// Adds the friction of drives that turn one joint to what that joint has itself: by virtual work,
/// dry friction by the ratio and viscous by its square. Of drives that turn several their tendons
/// have it (write_drives).
void add_friction(const std::vector<Drive>& drives, dynamics::Tree& tree);

/// Makes servos of drives: gains at the joint that a drive turns alone, of that joint's armature in
/// `tree`, else at its tendon, of its own inertia (actuator/motor/servo_gains.hpp). Throws
/// io::SpecError, naming it, where a drive has no inertia.
void make_servos(const Robot& robot, const dynamics::Tree& tree, std::vector<Drive>& drives,
                 std::vector<std::string>& notes);

/// <tendon> and <actuator>: drives, whose control is the voltage in V, the torque in Nm of those
/// that are known by their curve, or a servo's angle in rad, by a joint or by a tendon of
/// several, which has the drive's friction; motors of all joints that have a torque limit.
void write_drives(tinyxml2::XMLPrinter& out, const Robot& robot, const std::vector<Drive>& drives);

}  // namespace torquewright::hopper
