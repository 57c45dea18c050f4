// SPDX-License-Identifier: Apache-2.0
#include "hopper/replay/joint_findings.hpp"

#include "hopper/demand/joint_excess.hpp"
#include "robot/model/whole_body.hpp"

namespace torquewright::hopper {

std::vector<Finding> joint_findings(const Robot& robot, const Record& record) {
  std::vector<JointExcess> joints;
  for (std::size_t body = 1; body < robot.tree.bodies.size(); ++body) {
    joints.emplace_back(robot.tree.bodies[body].joint);
  }
  WholeBody body(robot);
  const Eigen::Index behind_base =
      robot.tree.velocity_size() - static_cast<Eigen::Index>(joints.size());
  Eigen::VectorXd effort(robot.tree.velocity_size());
  for (const RecordRow& row : record.rows) {
    effort.setZero();
    const bool is_reached = body.set(row.position, row.velocity);
    if (is_reached) body.add_drive_torques(row.torque_Nm, effort);
    for (std::size_t i = 0; i < joints.size(); ++i) {
      const Eigen::Index at = behind_base + static_cast<Eigen::Index>(i);
      joints[i].note_speed(row.velocity[at], row.time_s);
      joints[i].note_effort(effort[at], row.time_s);
    }
  }
  std::vector<Finding> findings;
  for (const JointExcess& joint : joints) joint.add_to(findings, record.rows.size());
  return findings;
}

}  // namespace torquewright::hopper
