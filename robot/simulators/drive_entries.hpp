// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "actuator/exporters/exporter.hpp"
#include "robot/model/robot.hpp"

namespace torquewright::hopper {

/// What the file of one actuator says of itself.
struct ActuatorNote {
  std::string file;
  std::vector<std::string> lines;
};

/// A robot's drives by the law of a simulator that limits torque joint by joint.
struct DriveEntries {
  std::vector<actuator::DriveEntry> entries;
  std::vector<std::string> notes;       ///< What the joints' own laws leave out.
  std::vector<ActuatorNote> actuators;  ///< Each document once, with the errors of its law.
  dynamics::Tree tree;                  ///< With the rotors in its joints.
};

/// Drives that are alike share an entry. Joints that a linkage couples, or turns at a ratio that
/// changes, have what each has alone at the posture nearest to zero. `friction` at the joint: of
/// every drive whose gear does not lock itself, and with what the joint has itself. Requires an
/// exporter whose law has parameters; throws io::SpecError where a drive has no region or the robot
/// has no drives.
DriveEntries drive_entries(const Robot& robot, const actuator::Exporter& exporter,
                           actuator::FrictionPlace friction);

/// Says where the passive forces of joints stand, once: in the drives' friction or in the robot's
/// own file.
void note_own_forces(const Robot& robot, actuator::FrictionPlace friction,
                     std::vector<std::string>& notes);

/// What each actuator's file says, as lines for a file's head.
std::vector<std::string> actuator_lines(const DriveEntries& drives);

}  // namespace torquewright::hopper
