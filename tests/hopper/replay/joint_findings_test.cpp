// SPDX-License-Identifier: Apache-2.0
// Oracle: virtual work by hand. Two drives lift a joint each and one of them both, so that joints
// have A^T of the drives' torques: with A = [1 0; 2 1] they are tau_1 + 2 tau_2 and tau_2.
#include "hopper/replay/joint_findings.hpp"

#include <gtest/gtest.h>

#include "tests/hopper/replay/driven_robot.hpp"

namespace torquewright::hopper {
namespace {

Robot coupled(double effort_max, double speed_max) {
  Robot robot;
  robot.tree.base = dynamics::BaseKind::kFixed;
  robot.tree.bodies.resize(3);
  for (std::size_t body = 1; body < 3; ++body) {
    robot.tree.bodies[body].parent = body - 1;
    robot.tree.bodies[body].joint.name = "joint_" + std::to_string(body);
    robot.tree.bodies[body].joint.axis = {0.0, 1.0, 0.0};
  }
  robot.tree.bodies[1].joint.limits.effort_max = effort_max;
  robot.tree.bodies[2].joint.limits.speed_max = speed_max;
  Drivetrain drivetrain;
  drivetrain.mechanism =
      std::make_shared<ConstantJacobian>("parallel", SmallMatrix{{1.0, 0.0}, {2.0, 1.0}});
  drivetrain.joints = {1, 2};
  drivetrain.actuators = {actuator::round_actuator(), actuator::round_actuator()};
  drivetrain.actuator_names = {"one", "other"};
  robot.drivetrains.push_back(drivetrain);
  return robot;
}

Record run_of(double sign) {
  Record record;
  for (const double time_s : {0.0, 0.1}) {
    RecordRow row;
    row.time_s = time_s;
    row.position = Eigen::Vector2d::Zero();
    row.velocity = sign * Eigen::Vector2d(1.0, 3.0);
    row.torque_Nm = sign * (time_s > 0.0 ? Eigen::Vector2d(4.0, 5.0) : Eigen::Vector2d(1.0, 1.0));
    record.rows.push_back(row);
  }
  return record;
}

TEST(JointFindings, AreOfTheJointAndNotOfItsDrive) {
  for (const double sign : {1.0, -1.0}) {
    const auto findings = joint_findings(coupled(13.9, 2.9), run_of(sign));
    ASSERT_EQ(findings.size(), 2u);
    EXPECT_EQ(findings[0].rule, "joint-torque");
    EXPECT_EQ(findings[0].joint, "joint_1");
    EXPECT_NEAR(*findings[0].value, sign * 14.0, 1e-12);
    EXPECT_EQ(*findings[0].time_s, 0.1);
    EXPECT_NE(findings[0].sentence.find("(1 of 2 samples beyond)"), std::string::npos);
    EXPECT_EQ(findings[1].rule, "joint-speed");
    EXPECT_EQ(*findings[1].value, sign * 3.0);
    EXPECT_EQ(findings[1].severity, actuator::Severity::kViolation);
  }
}

TEST(JointFindings, OfAJointWithinItsLimitsThereAreNone) {
  EXPECT_TRUE(joint_findings(coupled(14.1, 3.1), run_of(1.0)).empty());
}

}  // namespace
}  // namespace torquewright::hopper
