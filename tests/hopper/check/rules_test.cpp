// SPDX-License-Identifier: Apache-2.0
// Every rule alone, on motions and demands written by hand. Oracles: the rule's sentence in
// docs/checks.md worked out on paper: which sample is worst, by how much, of how many.
#include <gtest/gtest.h>

#include <numbers>

#include "hopper/check/hopper_check.hpp"
#include "hopper/check/rules/every_rule.hpp"
#include "hopper/demand/battery_draw.hpp"
#include "hopper/motion/motion_reader.hpp"
#include "robot/mechanisms/constant_jacobian.hpp"
#include "robot/model/robot_spec.hpp"
#include "tests/actuator/example_actuator.hpp"
#include "tests/hopper/check/made_motion.hpp"

namespace torquewright::hopper {
namespace {

using actuator::Severity;
using Eigen::Index;

/// A robot in motion with nothing in it but what a test puts there.
struct Scene : check_test::MadeMotion {
  /// 10 ms a sample, from 1 s on; everything rests at zero.
  void take_samples(Index samples) {
    for (Index i = 0; i < samples; ++i) {
      motion.times_s.push_back(1.0 + 0.01 * static_cast<double>(i));
    }
    const auto points = static_cast<Index>(robot.contacts.size());
    const Index joints = static_cast<Index>(robot.tree.bodies.size()) - 1;
    motion.positions.setZero(robot.tree.position_size(), samples);
    motion.velocities.setZero(robot.tree.velocity_size(), samples);
    motion.efforts.setZero(joints, samples);
    motion.has_effort.assign(static_cast<std::size_t>(joints), false);
    contacts.touches.setConstant(points, samples, true);
    contacts.height_m.setZero(points, samples);
    demand.joint_effort.setZero(joints, samples);
    demand.forces_N.setZero(3 * points, samples);
    demand.weight_N = 100.0;
    demand.size_m = 0.5;
  }
};

void add_body(Robot& robot, const std::string& name, dynamics::JointKind kind) {
  dynamics::Body body;
  body.name = name;
  body.joint.name = name;
  body.joint.kind = kind;
  robot.tree.bodies.push_back(body);
}

/// A base in the plane (three rows before the joints'), a hinge and a slide.
Scene arm() {
  Scene scene;
  scene.robot.tree.base = dynamics::BaseKind::kPlanar;
  scene.robot.tree.bodies.emplace_back();
  add_body(scene.robot, "hinge", dynamics::JointKind::kRevolute);
  add_body(scene.robot, "slide", dynamics::JointKind::kPrismatic);
  scene.robot.tree.bodies[1].joint.limits = {-1.0, 2.0, 4.0, 30.0};
  scene.robot.tree.bodies[2].joint.limits = {-0.1, 0.2, 0.5, 80.0};
  scene.take_samples(5);
  return scene;
}

void expect_finding(const Finding& finding, const char* rule, const char* joint, double time_s,
                    double value, double limit) {
  EXPECT_EQ(finding.rule, rule);
  EXPECT_EQ(finding.joint, joint);
  EXPECT_DOUBLE_EQ(*finding.time_s, time_s) << rule;
  EXPECT_DOUBLE_EQ(*finding.value, value) << rule;
  EXPECT_DOUBLE_EQ(*finding.limit, limit) << rule;
}

// Two drives that are known by curves, on a robot with a battery: 3 Nm at 2 rad/s and 5 N at
// 0.4 m/s, of which the second brakes for half of the time: 8 W at most, 6 W x 40 ms + 2 W x 20 ms,
// and half a step of 2 W on the way between.
TEST(BatteryDraw, IsSaidToBeUnknownOfCurves) {
  Scene scene = arm();
  for (std::size_t body = 1; body <= 2; ++body) {
    Drivetrain& drivetrain = scene.robot.drivetrains.emplace_back();
    drivetrain.joints = {body};
    drivetrain.actuators.emplace_back().envelope.emplace();
    drivetrain.actuator_names = {body == 1 ? "hinge" : "slide"};
  }
  scene.demand.has_dynamics = true;
  scene.demand.drives = {std::vector<DriveInstant>(5, {0, 2.0, 0, 3.0, 3.0, 0}),
                         std::vector<DriveInstant>(5, {0, 0.4, 0, 5.0, 5.0, 0})};
  scene.demand.drives[1][3].torque_Nm = scene.demand.drives[1][4].torque_Nm = -5.0;
  EXPECT_TRUE(battery_draw(scene.checked()).empty());  // no battery, nothing to take from it
  scene.robot.battery = "{}";
  const std::vector<Finding> findings = battery_draw(scene.checked());
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_NE(
      findings[0].sentence.find("what hinge, slide take from the robot's battery is not known"),
      std::string::npos)
      << findings[0].sentence;
  EXPECT_NE(findings[0].sentence.find("0.29 J, 8 W at most"), std::string::npos)
      << findings[0].sentence;
  scene.robot.drivetrains[0].actuators[0].envelope.reset();
  scene.robot.drivetrains[1].actuators[0].envelope.reset();
  EXPECT_TRUE(battery_draw(scene.checked()).empty());
}

TEST(JointLimits, NameTheSampleFurthestBeyondEitherEnd) {
  Scene scene = arm();
  scene.motion.positions.row(3) << -1.2, 0.0, 2.5, 2.1, 2.0;  // 0.2, 0.5 and 0.1 beyond
  scene.motion.velocities.row(4) << 0.0, -0.75, 0.5, 0.6, 0.0;
  const std::vector<Finding> findings = joint_limits(scene.checked());
  ASSERT_EQ(findings.size(), 2u);
  expect_finding(findings[0], "joint-range", "hinge", 1.02, 2.5, 2.0);
  EXPECT_EQ(findings[0].unit, "rad");
  EXPECT_NE(findings[0].sentence.find("3 of 5 samples"), std::string::npos);
  expect_finding(findings[1], "joint-speed", "slide", 1.01, -0.75, 0.5);
  EXPECT_EQ(findings[1].unit, "m/s");
  EXPECT_NE(findings[1].sentence.find("2 of 5 samples"), std::string::npos);
  for (const Finding& finding : findings) EXPECT_EQ(finding.severity, Severity::kViolation);
}

TEST(JointLimits, TakeTheFilesTorqueWhereItHasOneElseTheDynamics) {
  Scene scene = arm();
  scene.motion.has_effort[0] = true;
  scene.motion.efforts.row(0) << 0.0, -31.0, 0.0, -33.0, 32.0;
  scene.motion.efforts.row(1).setConstant(900.0);  // of no column of the file
  scene.demand.joint_effort.row(0).setConstant(900.0);
  scene.demand.joint_effort.row(1) << 81.0, 0.0, 0.0, 0.0, 80.0;
  const std::vector<Finding> findings = joint_limits(scene.checked());
  ASSERT_EQ(findings.size(), 2u);
  expect_finding(findings[0], "joint-torque", "hinge", 1.03, -33.0, 30.0);
  EXPECT_EQ(findings[0].unit, "Nm");
  expect_finding(findings[1], "joint-torque", "slide", 1.0, 81.0, 80.0);
  EXPECT_EQ(findings[1].unit, "N");
  scene.demand.has_dynamics = false;  // then only the file's is known
  EXPECT_EQ(joint_limits(scene.checked()).size(), 1u);
}

TEST(JointLimits, TakeTheTorqueOfTheDynamicsWhereTheseAreAskedFor) {
  Scene scene = arm();
  scene.motion.has_effort[0] = true;
  scene.motion.efforts.row(0).setConstant(900.0);
  scene.demand.joint_effort.row(0) << 0.0, 0.0, 31.0, 0.0, 0.0;
  scene.options.torques = TorqueSource::kDynamics;
  const std::vector<Finding> findings = joint_limits(scene.checked());
  ASSERT_EQ(findings.size(), 1u);
  expect_finding(findings[0], "joint-torque", "hinge", 1.02, 31.0, 30.0);
}

TEST(SlideUnits, NameTheDrivesOfSlidesAlone) {
  Scene scene = arm();
  Drivetrain hinge, slide;
  hinge.joints = {1};
  hinge.actuator_names = {"hip"};
  scene.robot.drivetrains = {hinge};
  EXPECT_TRUE(slide_units(scene.checked()).empty());
  slide.joints = {2};
  slide.actuator_names = {"rail"};
  scene.robot.drivetrains.push_back(slide);
  const std::vector<Finding> findings = slide_units(scene.checked());
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_EQ(findings[0].severity, Severity::kNote);
  EXPECT_EQ(findings[0].sentence.find("rail: "), 0u);
}

// The slide has no drive and is pushed by 2 N at most; of 1e-8 N nobody need know.
TEST(JointWithoutDrive, IsNamedWithWhatItNeeds) {
  Scene scene = arm();
  scene.demand.joint_effort.row(0).setConstant(30.0);
  scene.demand.joint_effort.row(1) << 1.0, -2.0, 0.0, 0.0, 1.5;
  EXPECT_TRUE(joint_without_drive(scene.checked()).empty());  // no drive at all: another finding
  Drivetrain hinge;
  hinge.joints = {1};
  scene.robot.drivetrains = {hinge};
  const std::vector<Finding> findings = joint_without_drive(scene.checked());
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_EQ(findings[0].severity, Severity::kNote);
  EXPECT_NE(findings[0].sentence.find("slide 2 N"), std::string::npos) << findings[0].sentence;
  EXPECT_EQ(findings[0].sentence.find("hinge"), std::string::npos);
  scene.demand.joint_effort.row(1).setConstant(1e-8);
  EXPECT_TRUE(joint_without_drive(scene.checked()).empty());
}

// 1e-9 of the limit, or of 1 where that is less, is rounding.
TEST(JointLimits, GrantRoundingAndNoMore) {
  Scene scene = arm();
  scene.motion.positions.row(3).setConstant(2.0 + 1.9e-9);
  scene.motion.positions.row(4).setConstant(0.2 + 0.9e-9);
  EXPECT_TRUE(joint_limits(scene.checked()).empty());
  scene.motion.positions.row(3).setConstant(2.0 + 2.1e-9);
  scene.motion.positions.row(4).setConstant(0.2 + 1.1e-9);
  EXPECT_EQ(joint_limits(scene.checked()).size(), 2u);
}

/// One body that stands on a rectangle of 0.2 m by 0.1 m about the point (0.3, 0) of the world.
Scene foot() {
  Scene scene;
  scene.robot.tree.bodies.emplace_back();
  scene.robot.tree.bodies[0].name = "foot";
  for (const double x : {0.2, 0.4}) {
    for (const double y : {-0.05, 0.05}) {
      scene.robot.contacts.push_back(
          {"point" + std::to_string(scene.robot.contacts.size()), {0, {x, y, 0}}, 0.6, 0.0});
    }
  }
  scene.take_samples(4);
  return scene;
}

void push(Scene& scene, Index point, Index sample, const Eigen::Vector3d& force_N) {
  scene.demand.forces_N.block<3, 1>(3 * point, sample) = force_N;
}

// Tangential over normal: point 0 uses 0.3 of 0.6, point 1 0.25 of 0.3, which is more of its own.
TEST(FrictionCone, NotesThePointThatUsesMostOfIts) {
  Scene scene = foot();
  scene.robot.contacts[1].friction_coefficient = 0.3;
  push(scene, 0, 1, {9.0, -12.0, 50.0});  // 15 of 50
  push(scene, 0, 2, {0.0, 2.0, 50.0});
  push(scene, 1, 3, {0.0, -10.0, 40.0});  // 10 of 40
  push(scene, 2, 3, {0.9, 0.0, 0.18});    // 5 of less than a hundredth of the weight: no ratio
  const std::vector<Finding> findings = friction_cone(scene.checked());
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_EQ(findings[0].severity, Severity::kNote);
  expect_finding(findings[0], "friction-cone", "point1", 1.03, 0.25, 0.3);
}

TEST(FrictionCone, IsBrokenByEveryPointThatSlipsOrIsPulled) {
  Scene scene = foot();
  push(scene, 0, 0, {0.0, 30.0, 40.0});  // 0.75
  push(scene, 0, 1, {33.0, 0.0, 50.0});  // 0.66
  push(scene, 1, 2, {30.0, 0.0, 50.0});  // at its edge
  push(scene, 2, 1, {0.0, 0.0, -4.0});
  push(scene, 2, 2, {0.0, 0.0, -7.0});
  push(scene, 2, 3, {0.0, 0.0, -5.0});
  push(scene, 3, 2, {0.0, 0.0, -0.9});  // less than a hundredth of the weight
  const std::vector<Finding> findings = friction_cone(scene.checked());
  ASSERT_EQ(findings.size(), 3u);
  expect_finding(findings[0], "friction-cone", "point0", 1.0, 0.75, 0.6);
  expect_finding(findings[1], "ground-pulls", "point2", 1.02, -7.0, 0.0);
  expect_finding(findings[2], "friction-cone", "point1", 1.02, 0.6, 0.6);
  EXPECT_EQ(findings[0].severity, Severity::kViolation);
  EXPECT_EQ(findings[1].severity, Severity::kViolation);
  EXPECT_EQ(findings[2].severity, Severity::kNote);
  scene.demand.has_dynamics = false;
  EXPECT_TRUE(friction_cone(scene.checked()).empty());
}

// Levers: with 10, 20, 30 and 60 N the pressure's centre lies 90 of 120 along x, 80 of 120 along y:
// 0.05 m from the far side and 0.1/3 m from the left one.
TEST(CentreOfPressure, ComesNearestToTheEdgeWhereLeversSay) {
  Scene scene = foot();
  for (Index point = 0; point < 4; ++point) {
    push(scene, point, 0, {5.0, 0.0, 25.0});  // in the middle
    push(scene, point, 1, {0.0, 0.0, std::array{10.0, 20.0, 30.0, 60.0}[point]});
    push(scene, point, 2, {0.0, 0.0, point == 3 ? 0.9 : 0.0});  // bears no load: below a hundredth
  }
  scene.contacts.touches.col(3).setConstant(false);
  const std::vector<Finding> findings = center_of_pressure(scene.checked());
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_EQ(findings[0].severity, Severity::kNote);
  EXPECT_EQ(findings[0].joint, "foot");
  EXPECT_DOUBLE_EQ(*findings[0].time_s, 1.01);
  EXPECT_NEAR(*findings[0].value, 0.1 / 3.0, 1e-15);
}

// What does not touch bears nothing and bounds nothing: without point 3 the hull is a triangle,
// whose middle of pressure under three equal forces is a third of its heights from every side.
TEST(CentreOfPressure, IsOfTheTouchingPointsAlone) {
  Scene scene = foot();
  scene.contacts.touches.row(3).setConstant(false);
  for (Index point = 0; point < 4; ++point) {
    for (Index sample = 0; sample < 4; ++sample) push(scene, point, sample, {0.0, 0.0, 20.0});
  }
  const std::vector<Finding> findings = center_of_pressure(scene.checked());
  ASSERT_EQ(findings.size(), 1u);
  const double height_m = 0.2 * 0.1 / std::hypot(0.2, 0.1);  // on the longest side
  EXPECT_NEAR(*findings[0].value, height_m / 3.0, 1e-15);
  EXPECT_DOUBLE_EQ(*findings[0].time_s, 1.0);
  scene.contacts.touches.row(2).setConstant(false);  // two points span no area
  EXPECT_TRUE(center_of_pressure(scene.checked()).empty());
}

TEST(GroundPenetration, CountsBelowTheHeightThatIsTouching) {
  Scene scene = foot();
  scene.contacts.height_m.row(0) << 0.0, -1.9e-3, 0.0, 0.0;
  scene.contacts.height_m.row(2) << 0.0, -3e-3, -5e-3, -4e-3;
  const std::vector<Finding> findings = ground_penetration(scene.checked());
  ASSERT_EQ(findings.size(), 1u);
  expect_finding(findings[0], "contact-below-ground", "point2", 1.02, -5e-3, -2e-3);
  EXPECT_EQ(findings[0].severity, Severity::kViolation);  // it came from nowhere
}

// Closed form: a critically damped spring that is met at v sinks by v T/e; T is MuJoCo's 0.02 s
// over 0.9/0.95, that of its surface. Without load.
TEST(GroundPenetration, MayBeThatOfSoftGroundAtItsTouchDown) {
  Scene scene = foot();
  const double speed_m_s = (0.02 + 5e-3) / 0.015625;
  const double sinks_m = speed_m_s * 0.02 * 0.95 / 0.9 / std::exp(1.0);
  scene.motion.times_s = {1.0, 1.015625, 1.03125, 1.046875};
  for (const double share : {0.99, 1.01}) {
    scene.contacts.height_m.row(2) << 0.02, -5e-3, -share * sinks_m, -4e-3;
    const std::vector<Finding> findings = ground_penetration(scene.checked());
    ASSERT_EQ(findings.size(), 1u);
    expect_finding(findings[0], "contact-below-ground", "point2", 1.03125, -share * sinks_m,
                   -sinks_m);
    EXPECT_EQ(findings[0].severity, share < 1 ? Severity::kWarning : Severity::kViolation);
  }
  scene.options.contact.time_constant_s = 0.01;
  scene.contacts.height_m(2, 2) = -0.6 * sinks_m;
  EXPECT_EQ(ground_penetration(scene.checked())[0].severity, Severity::kViolation);
  scene.options.contact.time_constant_s = 0.02;
  scene.options.contact.height_m = 2e-3;  // stated: soft ground is no excuse
  EXPECT_EQ(ground_penetration(scene.checked())[0].severity, Severity::kViolation);
}

/// Two slides along x on one base, a ball of 0.1 m at each and one on the base.
Scene two_slides() {
  Scene scene;
  scene.robot.tree.bodies.emplace_back();
  scene.robot.tree.bodies[0].name = "rail";
  for (const char* name : {"left", "right"}) {
    add_body(scene.robot, name, dynamics::JointKind::kPrismatic);
    scene.robot.tree.bodies.back().joint.axis = Eigen::Vector3d::UnitX();
  }
  for (const std::size_t body : {1u, 0u, 2u}) {
    scene.robot.spheres.push_back({{body, Eigen::Vector3d::Zero()}, 0.1});
  }
  scene.take_samples(4);
  return scene;
}

// Both slides run through the ball of the rail that carries them: that is by design.
TEST(SelfCollision, IsOfBodiesThatNoJointJoins) {
  Scene scene = two_slides();
  scene.motion.positions << -0.3, -0.1, 0.0, 0.3,  //
      0.3, 0.05, 0.13, 0.5;
  const std::vector<Finding> findings = self_collision(scene.checked());
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_EQ(findings[0].severity, Severity::kViolation);
  EXPECT_EQ(findings[0].joint, "left");
  EXPECT_DOUBLE_EQ(*findings[0].time_s, 1.02);
  EXPECT_NEAR(*findings[0].value, 0.13 - 0.2, 1e-15);
  scene.motion.positions.row(1).array() += 0.0701;  // 0.1 mm between them
  EXPECT_TRUE(self_collision(scene.checked()).empty());
}

/// A hinge with two margins: to 1 rad, of limit 2; to -1 rad, of limit 8, so that the same margin
/// is a lesser part of it.
class TwoStops : public ConstantJacobian {
 public:
  TwoStops() : ConstantJacobian(direct_drive()) {}
  std::vector<MechanismMargin> margins(const SmallVector& joint_rad) const override {
    return {{"ahead", 2.0, 2.0, 1.0 - joint_rad[0], "rad"},
            {"astern", 8.0, 8.0, 1.0 + joint_rad[0], "rad"}};
  }
};

Scene crank() {
  Scene scene = arm();
  Drivetrain drivetrain;
  drivetrain.mechanism = std::make_shared<TwoStops>();
  drivetrain.joints = {1};
  drivetrain.actuators = {actuator::round_actuator()};
  drivetrain.actuator_names = {"crank"};
  scene.robot.drivetrains = {drivetrain};
  return scene;
}

TEST(MechanismMargins, NoteTheLeastOfThemForItsSize) {
  Scene scene = crank();
  scene.motion.positions.row(3) << 0.0, -0.5, 0.3, 0.1, 0.0;  // 0.7 of 4, 0.5 of 16
  const std::vector<Finding> findings = mechanism_margins(scene.checked());
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_EQ(findings[0].severity, Severity::kNote);
  expect_finding(findings[0], "mechanism-margin", "crank", 1.01, 8.0, 8.0);
  EXPECT_NE(findings[0].sentence.find("astern"), std::string::npos);
  EXPECT_NE(findings[0].sentence.find("margin 0.5, the least of 2"), std::string::npos);
}

TEST(MechanismMargins, AreViolatedByEveryOneThatIsBroken) {
  Scene scene = crank();
  scene.motion.positions.row(3) << 0.0, -1.5, 1.25, 1.1, 1.5;
  const std::vector<Finding> findings = mechanism_margins(scene.checked());
  ASSERT_EQ(findings.size(), 2u);
  expect_finding(findings[0], "mechanism-margin", "crank", 1.04, 2.0, 2.0);
  expect_finding(findings[1], "mechanism-margin", "crank", 1.01, 8.0, 8.0);
  for (const Finding& finding : findings) EXPECT_EQ(finding.severity, Severity::kViolation);
}

// The motor of 200 Nm can give 2 Nm s in the 10 ms before the jump.
TEST(ImpactByMotors, IsHeldAgainstTheTimeBetweenTwoSamples) {
  Scene scene = crank();
  const auto jolt = [&](Index sample, double drive_Nm_s) {
    Jolt one;
    one.sample = sample;
    one.time_s = scene.motion.time_s(sample);
    one.drive_Nm_s.setConstant(1, drive_Nm_s);
    scene.demand.jolts.push_back(one);
  };
  EXPECT_TRUE(impact_by_motors(scene.checked()).empty());
  // A thousandth of weight times size over the window of 10 ms: 5e-4 Nm s.
  jolt(1, 4.9e-4);
  EXPECT_TRUE(impact_by_motors(scene.checked()).empty());
  jolt(2, -1.5);
  jolt(3, 1.2);
  const std::vector<Finding> possible = impact_by_motors(scene.checked());
  ASSERT_EQ(possible.size(), 1u);
  EXPECT_EQ(possible[0].severity, Severity::kNote);
  EXPECT_EQ(possible[0].joint, "crank");
  EXPECT_DOUBLE_EQ(*possible[0].time_s, 1.02);
  EXPECT_DOUBLE_EQ(*possible[0].value, 1.5);
  EXPECT_NEAR(*possible[0].limit, 2.0, 1e-12);
  jolt(4, 2.1);
  const std::vector<Finding> impossible = impact_by_motors(scene.checked());
  ASSERT_EQ(impossible.size(), 1u);
  EXPECT_EQ(impossible[0].severity, Severity::kWarning);
  EXPECT_DOUBLE_EQ(*impossible[0].value, 2.1);
  // Friction of 5 Nm forward only: backward the motor and it hold 205 Nm.
  scene.robot.drivetrains[0].actuators[0].effects.push_back(
      actuator::effect("asymmetric_friction", {5.0, 0.0, 0.0, 0.0}));
  EXPECT_NEAR(*impact_by_motors(scene.checked())[0].limit, 2.05, 1e-12);
}

// A motion made in memory need have no table of the efforts that it does not state. Oracle: the
// same motion with one.
TEST(JointTorque, IsHeldAgainstItsLimitWithoutATableOfEfforts) {
  Robot robot = read_robot(TORQUEWRIGHT_SOURCE_DIR "/specs/robot/hopper.json").robot;
  for (dynamics::Body& body : robot.tree.bodies) body.joint.limits.effort_max = 1.0;
  Motion with = read_motion(
      robot, {TORQUEWRIGHT_SOURCE_DIR "/specs/trajectory/hopper_squat.csv", {}, {}, {}});
  const Index joints = static_cast<Index>(robot.tree.bodies.size()) - 1;
  with.has_effort.assign(static_cast<std::size_t>(joints), false);
  with.efforts.setZero(joints, with.samples());
  Motion without = with;
  without.efforts.resize(0, 0);
  const auto torques_beyond = [&](Motion& motion) {
    std::vector<std::string> found;
    for (const Finding& finding : check_motion(robot, motion, {}).check.findings) {
      if (finding.rule == "joint-torque") found.push_back(finding.sentence);
    }
    return found;
  };
  const std::vector<std::string> expected = torques_beyond(with);
  EXPECT_FALSE(expected.empty());
  EXPECT_EQ(torques_beyond(without), expected);
}

}  // namespace
}  // namespace torquewright::hopper
