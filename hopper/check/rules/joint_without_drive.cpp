// SPDX-License-Identifier: Apache-2.0
// What joints would need that no drive moves: only what is gross is unexplained
// (base_residual.hpp).
#include <fmt/format.h>

#include <set>

#include "hopper/check/rules/every_rule.hpp"
#include "io/text/wording.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;

constexpr double kRoundOff = 1e-9;  ///< Of the robot's weight, and that times its size.

std::set<std::size_t> driven_joints(const Robot& robot) {
  std::set<std::size_t> joints;
  for (const Drivetrain& drivetrain : robot.drivetrains) {
    joints.insert(drivetrain.joints.begin(), drivetrain.joints.end());
  }
  return joints;
}

}  // namespace

std::vector<Finding> joint_without_drive(const CheckedMotion& checked) {
  const Demand& demand = checked.demand;
  if (!demand.has_dynamics || checked.robot.drivetrains.empty()) return {};
  const std::set<std::size_t> driven = driven_joints(checked.robot);
  std::vector<std::string> needs;
  for (Index i = 0; i < demand.joint_effort.rows(); ++i) {
    const auto body = static_cast<std::size_t>(i) + 1;
    const dynamics::Joint& joint = checked.robot.tree.bodies[body].joint;
    const bool turns = joint.kind == dynamics::JointKind::kRevolute;
    const double greatest = demand.joint_effort.row(i).cwiseAbs().maxCoeff();
    const double least = kRoundOff * demand.weight_N * (turns ? demand.size_m : 1.0);
    if (driven.contains(body) || !(greatest > least)) continue;
    needs.push_back(fmt::format("{} {:.4g} {}", joint.name, greatest, turns ? "Nm" : "N"));
  }
  if (needs.empty()) return {};
  Finding finding;
  finding.rule = "joint-without-drive";
  finding.sentence = fmt::format(
      "joints that no drive moves, and the most that the motion needs of each: {}; no region "
      "bounds "
      "that, only --residual-limit",
      io::listed(needs));
  return {finding};
}

}  // namespace torquewright::hopper
