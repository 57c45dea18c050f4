// SPDX-License-Identifier: Apache-2.0
// Ranges, speeds and torques that the robot's document states of its joints.
#include "hopper/check/rules/every_rule.hpp"
#include "hopper/demand/drive_reports.hpp"
#include "hopper/demand/joint_excess.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;

/// Those of the dynamics have the rotors' torque, which is a joint's too.
bool counts_file(const CheckedMotion& checked) {
  if (checked.options.torques == TorqueSource::kDynamics) return false;
  return !drive_torques(checked).adds_rotors;
}

}  // namespace

std::vector<Finding> joint_limits(const CheckedMotion& checked) {
  std::vector<Finding> findings;
  const bool trusts_file = !checked.demand.has_dynamics || counts_file(checked);
  const Motion& motion = checked.motion;
  const Index joints = static_cast<Index>(checked.robot.tree.bodies.size()) - 1;
  for (Index i = 0; i < joints; ++i) {
    const dynamics::Joint& joint = checked.robot.tree.bodies[static_cast<std::size_t>(i) + 1].joint;
    const auto positions = motion.positions.row(motion.positions.rows() - joints + i);
    const auto speeds = motion.velocities.row(motion.velocities.rows() - joints + i);
    JointExcess excess(joint);
    for (Index sample = 0; sample < motion.samples(); ++sample) {
      const double time_s = motion.time_s(sample);
      excess.note_position(positions[sample], time_s);
      excess.note_speed(speeds[sample], time_s);
      const bool is_of_file = motion.has_effort[static_cast<std::size_t>(i)] && trusts_file;
      if (!is_of_file && !checked.demand.has_dynamics) continue;
      excess.note_effort(
          is_of_file ? motion.efforts(i, sample) : checked.demand.joint_effort(i, sample), time_s);
    }
    excess.add_to(findings, static_cast<std::size_t>(motion.samples()));
  }
  return findings;
}

}  // namespace torquewright::hopper
