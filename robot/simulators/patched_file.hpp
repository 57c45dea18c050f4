// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "actuator/friction/joint_friction.hpp"
#include "actuator/motor/actuator.hpp"

namespace torquewright::hopper {

/// What a drive is to the joint that it alone turns, as simulators' files of robots have it.
struct DriveNumbers {
  double torque_Nm = 0.0;    ///< Greatest at rest, at the peak rating.
  double speed_rad_s = 0.0;  ///< Up to which it drives.
  double armature_kg_m2 = 0.0;
  /// Of the joint, which torque and speed are then without; none: the document states none, or the
  /// gear locks itself and the friction is in torque and speed.
  std::optional<actuator::JointFriction> friction;
};

/// Throws io::SpecError where the drive has no torque at rest. `file` is its document's.
DriveNumbers drive_numbers(const actuator::Actuator& actuator, const std::string& file);

/// A pattern of joints' names ("*" stands for any letters) and what turns those.
struct PatchedDrive {
  std::string pattern;
  DriveNumbers numbers;
};

/// A robot's own file with the numbers of drives in it.
struct PatchedFile {
  std::string text;
  std::vector<std::string> joints;  ///< Whose numbers were written, in the file's order.
  std::vector<std::string> notes;   ///< What was not written, and why.
};

/// Writes effort, velocity, damping and friction into the joints of a URDF; armature, damping and
/// frictionloss into the joints of an MJCF and forcerange into the actuators that turn them. All
/// other bytes stay. `file` is the name for messages, `text` its content. Throws io::SpecError
/// where a pattern fits no joint, two fit one, or another change would be needed than that of the
/// numbers.
PatchedFile patched_file(const std::string& file, const std::string& text,
                         const std::vector<PatchedDrive>& drives);

/// What lies between two texts, a line each: "12 - old" and "12 + new".
std::string line_difference(const std::string& before, const std::string& after);

}  // namespace torquewright::hopper
