// SPDX-License-Identifier: Apache-2.0
// Landings and loads by hand. Oracles: momentum (impulse is mass times change of speed, plus what
// gravity does meanwhile), levers, and the published 21 Nm at the motor of an 8:1 ankle, which are
// 168 Nm at its joint (seed 000).
#include <gtest/gtest.h>

#include <cmath>

#include "hopper/check/hopper_check.hpp"
#include "hopper/check/series.hpp"
#include "robot/mechanisms/constant_jacobian.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;

/// A block of 10 kg on four feet.
Robot block() {
  Robot robot;
  robot.tree.base = dynamics::BaseKind::kSpatial;
  dynamics::Body body;
  body.name = "block";
  body.inertia = {10, {0, 0, 0.2}, 0.4 * Eigen::Matrix3d::Identity()};
  robot.tree.bodies.push_back(body);
  int foot = 0;
  for (const double x : {0.1, -0.1}) {
    for (const double y : {0.05, -0.05}) {
      robot.contacts.push_back({"foot" + std::to_string(foot++), {0, {x, y, 0}}, 0.6, 0});
    }
  }
  return robot;
}

/// Falls from 0.2 m, stands from touch-down on; 1 ms steps.
Motion drop(const Robot& robot, bool with_rates) {
  constexpr double kGravity = 9.81;
  Motion motion;
  for (int i = 0; i < 400; ++i) motion.times_s.push_back(1e-3 * i);
  motion.positions.setZero(7, motion.samples());
  motion.positions.row(3).setOnes();
  motion.velocities.setZero(6, motion.samples());
  motion.accelerations.setZero(6, motion.samples());
  for (Index i = 0; i < motion.samples(); ++i) {
    const double t = motion.time_s(i);
    const double height_m = 0.2 - 0.5 * kGravity * t * t;
    if (height_m <= 0) continue;
    motion.positions(2, i) = height_m;
    motion.velocities(2, i) = -kGravity * t;
    motion.accelerations(2, i) = -kGravity;
  }
  motion.velocity_origin = with_rates ? Origin::kGiven : Origin::kAbsent;
  motion.acceleration_origin = motion.velocity_origin;
  (void)robot;
  return motion;
}

TEST(Landing, TakesTheImpulseOfItsFall) {
  const Robot robot = block();
  Motion motion = drop(robot, true);
  CheckOptions options;
  const HopperReport report = check_motion(robot, motion, options);
  EXPECT_EQ(report.demand.unsolved, 0u);
  ASSERT_EQ(report.demand.jolts.size(), 1u);
  const Jolt& jolt = report.demand.jolts.front();
  // Stops from 9.81 m/s2 times 0.201 s; the last step's gravity comes on top.
  const double speed_m_s = 9.81 * 0.201;
  EXPECT_NEAR(jolt.time_s, 0.202, 1e-12);
  for (Index i = 0; i < 4; ++i) {
    EXPECT_NEAR(jolt.impulses_N_s[3 * i + 2], (10 * speed_m_s + 98.1e-3) / 4, 1e-6);
  }
  EXPECT_NEAR(jolt.lost_energy_J, 0.5 * 10 * speed_m_s * speed_m_s, 1e-9);
  ASSERT_EQ(report.flights.size(), 1u);
  EXPECT_NEAR(report.flights[0].until_s, 0.201, 1e-12);
  for (Index i = 203; i < motion.samples(); ++i) {
    for (Index foot = 0; foot < 4; ++foot) {
      EXPECT_NEAR(report.demand.forces_N(3 * foot + 2, i), 98.1 / 4, 1e-6);
    }
  }
  EXPECT_LE(report.base_residual.force.mean, 1e-4);
}

// The same while it slides on at 1 m/s: the ground takes the fall's energy and leaves the slide's.
TEST(Landing, LosesTheEnergyOfItsFallAlone) {
  Robot robot = block();
  for (ContactPoint& contact : robot.contacts) contact.friction_coefficient = 0.0;
  Motion motion = drop(robot, true);
  motion.velocities.row(0).setConstant(1.0);
  for (Index i = 0; i < motion.samples(); ++i) motion.positions(0, i) = motion.time_s(i);
  const HopperReport report = check_motion(robot, motion, {});
  ASSERT_EQ(report.demand.jolts.size(), 1u);
  EXPECT_NEAR(report.demand.jolts[0].lost_energy_J, 0.5 * 10 * std::pow(9.81 * 0.201, 2), 1e-9);
}

TEST(Landing, IsFoundFromPositionsAlone) {
  const Robot robot = block();
  Motion motion = drop(robot, false);
  const HopperReport report = check_motion(robot, motion, {});
  ASSERT_EQ(report.demand.jolts.size(), 1u);
  double sum_N_s = 0.0;
  for (Index i = 0; i < 4; ++i) sum_N_s += report.demand.jolts[0].impulses_N_s[3 * i + 2];
  EXPECT_NEAR(sum_N_s, 10 * 9.81 * 0.202, 0.15);  // within one step and a half of gravity
}

TEST(Landing, BelowTheGroundIsAViolation) {
  const Robot robot = block();
  Motion motion = drop(robot, true);
  motion.positions.row(2).tail(50).setConstant(-0.03);
  const HopperReport report = check_motion(robot, motion, {});
  EXPECT_EQ(report.check.verdict, actuator::Verdict::kFail);
  const auto& first = report.check.findings.front();
  EXPECT_EQ(first.rule, "contact-below-ground");
  EXPECT_DOUBLE_EQ(*first.value, -0.03);
}

// Something pushes a flying body sideways at its centre of mass: a force and no moment about it,
// however the body is turned and wherever its frame sits.
TEST(Residual, IsOfTheCenterOfMass) {
  for (const auto base : {dynamics::BaseKind::kSpatial, dynamics::BaseKind::kPlanar}) {
    Robot robot = block();
    robot.tree.base = base;
    robot.tree.bodies[0].inertia.center_of_mass_m = {0.3, -0.1, 0.2};
    Motion motion;
    motion.times_s = {0, 0.01, 0.02};
    const Index size = robot.tree.velocity_size();
    motion.positions.setZero(robot.tree.position_size(), 3);
    motion.velocities.setZero(size, 3);
    motion.accelerations.setZero(size, 3);
    const bool is_planar = base == dynamics::BaseKind::kPlanar;
    const Index up = is_planar ? 1 : 2;
    motion.positions.row(up).setConstant(5);
    if (is_planar) {
      motion.positions.row(2).setConstant(0.7);
    } else {
      motion.positions.row(3).setConstant(0.8);
      motion.positions.row(4).setConstant(0.36);
      motion.positions.row(6).setConstant(0.48);
    }
    motion.accelerations.row(up).setConstant(-9.81);
    motion.accelerations.row(0).setConstant(1);  // 10 kg
    if (!is_planar) motion.accelerations.row(1).setConstant(2);
    const ContactSchedule contacts = schedule_contacts(robot, {}, motion);
    const Demand demand = demand_of(robot, motion, contacts);
    EXPECT_NEAR(demand.weight_N, 10 * 9.81, 1e-12);
    EXPECT_NEAR(demand.size_m, std::sqrt(0.4 * 3 / 2 / 10), 1e-14);  // radius of gyration
    const Eigen::VectorXd left = demand.residual.col(1);
    EXPECT_NEAR(left.head(demand.rows.forces).norm(), is_planar ? 10 : std::hypot(10, 20), 1e-12);
    EXPECT_LE(left.segment(demand.rows.forces, demand.rows.moments).norm(), 1e-12);
  }
}

// Oracle: levers. Behind a driven hinge hangs one that nothing drives, with 2 kg at 0.3 m held
// level: the ground cannot, so that its 2 * 9.81 * 0.3 Nm are left over, unless the file gives
// them.
TEST(Residual, OfAJointThatNothingDrivesIsLessWhatTheFileGives) {
  Robot robot;
  dynamics::Body ground;
  dynamics::Body driven;
  driven.joint.name = "driven";
  driven.inertia = {1.0, {0.1, 0, 0}, 1e-3 * Eigen::Matrix3d::Identity()};
  dynamics::Body hanging = driven;
  hanging.joint.name = "hanging";
  hanging.parent = 1;
  hanging.inertia = {2.0, {0.3, 0, 0}, 1e-3 * Eigen::Matrix3d::Identity()};
  robot.tree.bodies = {ground, driven, hanging};
  Drivetrain drivetrain;
  drivetrain.mechanism = std::make_shared<ConstantJacobian>(direct_drive());
  drivetrain.joints = {1};
  drivetrain.actuators.resize(1);
  drivetrain.actuator_names = {"driven"};
  robot.drivetrains = {drivetrain};
  Motion motion;
  motion.times_s = {0, 0.01, 0.02};
  motion.positions.setZero(2, 3);
  motion.velocities.setZero(2, 3);
  motion.accelerations.setZero(2, 3);
  const double held_Nm = -2.0 * 9.81 * 0.3;  // about +y, which turns x down
  motion.efforts.setZero(2, 3);
  motion.efforts.row(0).setConstant(77.0);
  motion.efforts.row(1).setConstant(0.75 * held_Nm);
  for (const bool is_given : {false, true}) {
    motion.has_effort = {false, is_given};
    const ContactSchedule contacts = schedule_contacts(robot, {}, motion);
    const Demand demand = demand_of(robot, motion, contacts);
    ASSERT_EQ(demand.residual.rows(), 1);
    EXPECT_NEAR(demand.residual(0, 1), (is_given ? 0.25 : 1.0) * held_Nm, 1e-12);
    HopperReport report;
    report.demand = demand;
    report.torques_Nm.setZero(1, 3);
    for (Eigen::MatrixXd* table :
         {&report.gears.joint_Nm, &report.gears.motor_Nm, &report.gears.impulse_Nm_s}) {
      table->setZero(1, 3);
    }
    const Series series = series_of(robot, motion, {}, report, SeriesDetail::kMotion);
    EXPECT_EQ(find_column(series, "driven_residual_torque_Nm"), nullptr);
    const Eigen::VectorXd* left = find_column(series, "hanging_residual_torque_Nm");
    ASSERT_NE(left, nullptr);
    EXPECT_EQ((*left)[1], demand.residual(0, 1));
  }
}

/// A lever on a fixed hinge, loaded at its end, which an 8:1 drive holds.
Robot lever() {
  Robot robot;
  dynamics::Body ground;
  dynamics::Body arm;
  arm.name = "lever";
  arm.joint.name = "ankle";
  arm.inertia = {1e-3, Eigen::Vector3d::Zero(), 1e-5 * Eigen::Matrix3d::Identity()};
  robot.tree.bodies = {ground, arm};
  robot.contacts.push_back({"tip", {1, {0.12, 0, 0}}, 0.6, 0});
  Drivetrain ankle;
  ankle.mechanism = std::make_shared<ConstantJacobian>(direct_drive());
  ankle.joints = {1};
  ankle.actuators.resize(1);
  ankle.actuators[0].motor.torque_constant_Nm_A = 0.44;
  ankle.actuators[0].motor.resistance_ohm = 0.35;
  ankle.actuators[0].drive = {
      .bus_voltage_V = 67.2, .peak_current_A = 50, .continuous_current_A = {}};
  ankle.actuators[0].transmission.ratio = 8;
  ankle.actuator_names = {"ankle"};
  ankle.actuator_files = {"ankle.json"};
  ankle.transmission_limit = {17, GearSide::kMotor, "stated"};
  robot.drivetrains = {ankle};
  return robot;
}

TEST(TransmissionLoad, IsTheMeanOverItsWindowOnBothSides) {
  const Robot robot = lever();
  Motion motion;
  for (int i = 0; i <= 100; ++i) motion.times_s.push_back(1e-3 * i);
  motion.positions.setZero(1, motion.samples());
  motion.velocities.setZero(1, motion.samples());
  motion.accelerations.setZero(1, motion.samples());
  motion.efforts.setZero(1, motion.samples());
  motion.has_effort = {false};
  motion.has_forces = true;
  motion.forces_N.setZero(3, motion.samples());
  // 168 Nm over 0.12 m for 20 ms: fills a window of 10 ms. Half as long fills it by half.
  motion.forces_N.row(2).segment(40, 21).setConstant(168 / 0.12);
  const HopperReport report = check_motion(robot, motion, {});
  ASSERT_EQ(report.transmission_loads.size(), 1u);
  const TransmissionLoad& load = report.transmission_loads.front();
  EXPECT_NEAR(load.joint.mean, 168, 1e-9);
  EXPECT_NEAR(load.motor.mean, 21, 1e-9);
  EXPECT_NEAR(load.motor.time_s, 0.040, 1e-12);
  bool is_said = false;
  for (const auto& finding : report.check.findings) {
    if (finding.rule != "transmission-load") continue;
    is_said = true;
    EXPECT_EQ(finding.severity, actuator::Severity::kViolation);
    EXPECT_NEAR(*finding.value, 21, 1e-9);
    EXPECT_EQ(*finding.limit, 17);
  }
  EXPECT_TRUE(is_said);
  motion.forces_N.setZero();
  motion.forces_N.row(2).segment(40, 5).setConstant(-168 / 0.12);
  const HopperReport brief = check_motion(robot, motion, {});
  // Straight lines between samples: 4 ms full, 1 ms rising, 1 ms falling.
  EXPECT_NEAR(brief.transmission_loads[0].joint.mean, 168 * 0.5, 1e-9);
}

// The same load at the joint's side, beside the joint's limit, and where none is stated.
TEST(TransmissionLoad, IsHeldAgainstTheLimitOfItsSideIfThereIsOne) {
  Robot robot = lever();
  Motion motion;
  for (int i = 0; i <= 100; ++i) motion.times_s.push_back(1e-3 * i);
  motion.positions.setZero(1, motion.samples());
  motion.velocities.setZero(1, motion.samples());
  motion.accelerations.setZero(1, motion.samples());
  motion.efforts.setZero(1, motion.samples());
  motion.has_effort = {false};
  motion.has_forces = true;
  motion.forces_N.setZero(3, motion.samples());
  motion.forces_N.row(2).segment(40, 21).setConstant(168 / 0.12);
  const auto found = [&] {
    for (const auto& finding : check_motion(robot, motion, {}).check.findings) {
      if (finding.rule == "transmission-load") return finding;
    }
    return Finding{};
  };
  // A window over the edge of the load may hold more by what the jump between samples leaves open.
  for (const double limit_Nm : {167.0, 185.0}) {
    robot.drivetrains[0].transmission_limit = {limit_Nm, GearSide::kJoint, "stated"};
    EXPECT_NEAR(*found().value, 168, 1e-9);
    EXPECT_EQ(*found().limit, limit_Nm);
    EXPECT_EQ(found().severity,
              limit_Nm < 168 ? actuator::Severity::kViolation : actuator::Severity::kNote);
  }
  robot.drivetrains[0].transmission_limit.reset();
  EXPECT_NEAR(*found().value, 21, 1e-9);  // at the motor, as strength is stated
  EXPECT_FALSE(found().limit);
  EXPECT_EQ(found().severity, actuator::Severity::kNote);
}

}  // namespace
}  // namespace torquewright::hopper
