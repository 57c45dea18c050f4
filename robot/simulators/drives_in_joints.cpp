// SPDX-License-Identifier: Apache-2.0
#include "robot/simulators/drives_in_joints.hpp"

#include <algorithm>

#include "robot/simulators/drive_entries.hpp"

namespace torquewright::hopper {
namespace {

/// The law's two numbers, as of actuator/exporters/urdf.cpp.
enum { kGreatestTorque, kGreatestSpeed };

void limit_joint(const actuator::DriveEntry& entry, dynamics::Joint& joint) {
  dynamics::JointLimits& limits = joint.limits;
  const auto within = [](double& stated, bool is_joints_own, double drives) {
    stated = is_joints_own ? std::min(stated, drives) : drives;
  };
  within(limits.effort_max, limits.owns_effort, entry.shape[kGreatestTorque]);
  within(limits.speed_max, limits.owns_speed, entry.shape[kGreatestSpeed]);
  if (!entry.friction) return;
  // The joint's own is in it.
  joint.passive.damping = entry.friction->viscous_Nm_s_rad;
  joint.passive.dry_friction = entry.friction->coulomb_Nm;
  joint.passive.static_friction = entry.friction->breakaway_Nm;
}

}  // namespace

Robot with_drives_in_joints(const Robot& robot, const actuator::Exporter& exporter,
                            actuator::FrictionPlace friction, DrivesInJoints& drives) {
  DriveEntries found = drive_entries(robot, exporter, friction);
  drives.are_there = true;
  drives.of_actuators = actuator_lines(found);
  drives.notes.insert(drives.notes.end(), found.notes.begin(), found.notes.end());
  Robot driven = robot;
  driven.tree = std::move(found.tree);
  for (Drivetrain& drivetrain : driven.drivetrains) drivetrain.rotors_in_tree = true;
  for (const actuator::DriveEntry& entry : found.entries) {
    for (const std::string& name : entry.joints) {
      limit_joint(entry, driven.tree.bodies[*driven.find_joint(name)].joint);
    }
  }
  return driven;
}

}  // namespace torquewright::hopper
