// SPDX-License-Identifier: Apache-2.0
#include "hopper/calibration/calibrate.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <filesystem>
#include <numbers>

#include "robot/mjcf/mjcf_reader.hpp"
#include "robot/model/robot_centroid.hpp"
#include "robot/model/robot_spec.hpp"
#include "tests/io/scratch_folder.hpp"

namespace torquewright::hopper::calibration {
namespace {

using nlohmann::json;

const std::filesystem::path kHopper =
    std::filesystem::path(TORQUEWRIGHT_SOURCE_DIR) / "specs/robot/hopper.json";

/// A bar of 3 kg and one of 2 kg on a hinge 0.3 m below the first one's origin.
json two_bars() {
  return json::parse(R"({"kind": "robot", "version": 1,
    "base": {"body": "upper", "motion": "planar"},
    "bodies": [
      {"name": "lower", "mass_kg": 2, "center_of_mass_m": [0, 0, -0.2],
       "inertia_kg_m2": {"xx": 0.02, "yy": 0.02, "zz": 0.001}},
      {"name": "upper", "mass_kg": 3, "center_of_mass_m": [0, 0, 0.1],
       "inertia_kg_m2": {"xx": 0.05, "yy": 0.05, "zz": 0.002}}],
    "joints": [{"name": "hinge", "type": "revolute", "parent": "upper", "child": "lower",
      "axis": [0, 1, 0], "position_m": [0, 0, -0.3], "range_rad": [0, 3]}],
    "postures": {"takeoff": {"hinge": 0.5}, "tuck": {"hinge": 2.5}}})");
}

ReadRobot robot_from(const json& root) {
  return robot_of(io::check_document(root, "robot", "r", ""));
}

/// Parallel axis theorem by hand: two inertias and the reduced mass times the squared distance of
/// the centres of mass, 0.4 m above the hinge and 0.2 m from it at the angle.
double two_bar_inertia_kg_m2(double angle_rad, double upper_kg_m2 = .05) {
  const double distance_m2 = .4 * .4 + .2 * .2 + 2 * .4 * .2 * std::cos(angle_rad);
  return upper_kg_m2 + .02 + 3. * 2. / 5. * distance_m2;
}

TEST(PitchInertia, IsThatOfTheParallelAxisTheorem) {
  Robot robot = robot_from(two_bars()).robot;
  for (const double angle_rad : {0.0, 0.5, 1.7, std::numbers::pi}) {
    const Posture posture{"", Eigen::VectorXd::Constant(1, angle_rad)};
    EXPECT_NEAR(pitch_inertia_kg_m2(robot.tree, posture), two_bar_inertia_kg_m2(angle_rad), 1e-14);
  }
}

/// A knee beside which a crank of 2 kg turns by a rod of 1 kg.
std::string with_heavy_rod() {
  return R"(<mujoco><compiler angle="radian"/><worldbody><body name="trunk"><freejoint/>
  <inertial pos="0.02 0 0.05" mass="6" diaginertia="0.08 0.07 0.05"/>
  <body name="crank" pos="0 0 0.3"><joint name="c" axis="0 1 0"/>
  <inertial pos="0.04 0 0" mass="2" diaginertia="4e-3 5e-3 3e-3"/>
  <body name="rod" pos="0.08 0 0"><joint name="r" axis="0 1 0"/>
  <inertial pos="0 0 -0.15" mass="1" diaginertia="8e-3 8e-3 1e-4"/></body></body>
  <body name="shank"><joint name="knee" axis="0 1 0" range="-1.2 1.2" limited="true"/>
  <inertial pos="0.02 0 -0.1" mass="1.5" diaginertia="0.02 0.03 0.015"/>
  <body name="foot" pos="0 0 -0.2"><joint name="toe" axis="0 1 0"/>
  <inertial pos="0.03 0 -0.02" mass="0.4" diaginertia="1e-3 1e-3 1e-3"/></body></body></body></worldbody>
  <equality><connect body1="shank" body2="rod" anchor="0.08 0 0"/></equality></mujoco>)";
}

// Oracle: the pitch of a velocity that the whole body's mass matrix gives an impulse of pitch,
// knee held: the inverse of the base's own six rows.
TEST(PitchInertia, CountsLinksOfLoops) {
  const test::ScratchFolder folder;
  const Robot robot = read_mjcf(folder.write("robot.xml", with_heavy_rod())).robot;
  WholeBody body(robot);
  ASSERT_EQ(body.links().size(), 2u);
  const Eigen::Index size = robot.tree.velocity_size();
  Eigen::MatrixXd mass(size, size);
  for (const double angle_rad : {-0.7, 0.0, 0.9}) {
    const Posture posture{"", Eigen::VectorXd::Constant(2, angle_rad)};
    ASSERT_TRUE(body.set(position_of(robot.tree, posture), Eigen::VectorXd::Zero(size)));
    body.mass_matrix(mass);
    const Eigen::MatrixXd held = mass.topLeftCorner<6, 6>().inverse();
    const double found_kg_m2 = pitch_inertia_kg_m2(robot, posture);
    EXPECT_NEAR(found_kg_m2, 1 / held(4, 4), 1e-12);
    EXPECT_GT(found_kg_m2, pitch_inertia_kg_m2(robot.tree, posture) + 0.05);

    Question question{robot.tree, {posture}, {}, {1.0, {{0, 1.0}}, .01}, robot};
    EXPECT_EQ(inertias_kg_m2(question, {}), std::vector<double>{found_kg_m2});
  }
}

Question question_of(const ReadRobot& read, double cam_Nm_s, std::vector<SpeedTarget> speeds,
                     const std::vector<std::string>& free) {
  Question question{read.robot.tree, read.robot.postures, {}, {cam_Nm_s, std::move(speeds), .01}};
  for (const std::string& text : free) {
    question.free.push_back(free_value(text, read.documents.front(), read.robot));
  }
  return question;
}

// Oracle: the two wanted inertias solved by hand for the hinge.
TEST(Calibrate, FindsTheAnglesOfTheClosedForm) {
  const ReadRobot read = robot_from(two_bars());
  const double cam_Nm_s = 1.0;
  const Question question = question_of(
      read, cam_Nm_s,
      {{0, cam_Nm_s / two_bar_inertia_kg_m2(.8)}, {1, cam_Nm_s / two_bar_inertia_kg_m2(2.1)}},
      {"/postures/takeoff/hinge", "/postures/tuck/hinge"});
  const Calibration found = calibrate(question);
  ASSERT_TRUE(found.is_met);
  EXPECT_NEAR(found.best->values[0], .8, 1e-3);
  EXPECT_NEAR(found.best->values[1], 2.1, 1e-3);
  EXPECT_LT(found.best->worst_error, 1e-4);
}

// Oracle: the closed form solved for the hinge at both ends of the tolerance.
TEST(Profile, EndsWhereTheToleranceIsUsedUp) {
  const ReadRobot read = robot_from(two_bars());
  const double speed_rad_s = 1 / two_bar_inertia_kg_m2(1.2);
  const Calibration found =
      calibrate(question_of(read, 1.0, {{0, speed_rad_s}}, {"/postures/takeoff/hinge"}));
  ASSERT_TRUE(found.is_met);
  ASSERT_EQ(found.profiles[0].ranges.size(), 1u);
  const auto angle_of = [](double inertia_kg_m2) {
    return std::acos(((inertia_kg_m2 - .07) / 1.2 - .2) / .16);
  };
  const double inertia_kg_m2 = two_bar_inertia_kg_m2(1.2);
  EXPECT_NEAR(found.profiles[0].ranges[0].low, angle_of(inertia_kg_m2 / .99), 1e-4);
  EXPECT_NEAR(found.profiles[0].ranges[0].high, angle_of(inertia_kg_m2 / 1.01), 1e-4);
}

// Of a valley the point nearest to the document: one wanted inertia, and of bar and angle (both
// free) the ones on the curve that by scan are the nearest, in shares of the bounds.
TEST(Calibrate, TellsThePointNearestToTheDocument) {
  const ReadRobot read = robot_from(two_bars());
  const double wanted = two_bar_inertia_kg_m2(.9, .08);
  const Calibration found =
      calibrate(question_of(read, 1.0, {{0, 1 / wanted}},
                            {"/bodies/1/inertia_kg_m2/yy,/bodies/1/inertia_kg_m2/xx=0.01:0.21",
                             "/postures/takeoff/hinge"}));
  double nearest = 1e9;
  double nearest_angle_rad = 0;
  for (double angle_rad = 0; angle_rad < 3; angle_rad += 1e-4) {
    const double bar_kg_m2 = wanted - two_bar_inertia_kg_m2(angle_rad, 0);
    const double distance = std::hypot((bar_kg_m2 - .05) / .2, (angle_rad - .5) / 3);
    if (bar_kg_m2 < .01 || bar_kg_m2 > .21 || distance >= nearest) continue;
    nearest = distance;
    nearest_angle_rad = angle_rad;
  }
  ASSERT_TRUE(found.is_met);
  EXPECT_NEAR(found.best->values[1], nearest_angle_rad, 5e-3);
  EXPECT_LT(found.best->worst_error, 1e-4);
}

// One inertia, both postures given: whatever is fitted, one of the figures is missed by hand.
TEST(Calibrate, SaysWhereTheFiguresCannotBeMet) {
  const ReadRobot read = robot_from(two_bars());
  const std::string both = "/bodies/1/inertia_kg_m2/yy,/bodies/1/inertia_kg_m2/xx=0.01:0.5";
  const double takeoff = two_bar_inertia_kg_m2(.5);
  const double tuck = two_bar_inertia_kg_m2(2.5);
  const Calibration consistent =
      calibrate(question_of(read, 1.0, {{0, 1 / takeoff}, {1, 1 / tuck}}, {both}));
  ASSERT_TRUE(consistent.is_met);
  EXPECT_NEAR(consistent.best->values[0], .05, 1e-5);
  EXPECT_TRUE(consistent.is_determined());
  const Calibration not_met =
      calibrate(question_of(read, 1.0, {{0, 1 / takeoff}, {1, 1.5 / tuck}}, {both}));
  EXPECT_FALSE(not_met.is_met);
  ASSERT_TRUE(not_met.best);
  EXPECT_GT(not_met.best->worst_error, .05);
  EXPECT_TRUE(not_met.profiles.empty());
}

// No body is wider about one axis than about the two others together.
TEST(Calibrate, KeepsToInertiasThatBodiesHave) {
  const ReadRobot read = robot_from(two_bars());
  const Question question = question_of(read, 1.0, {{0, 1 / two_bar_inertia_kg_m2(.5, .2)}},
                                        {"/bodies/1/inertia_kg_m2/yy=0.01:0.5"});
  const Calibration found = calibrate(question);
  ASSERT_TRUE(found.best);
  EXPECT_FALSE(found.is_met);
  EXPECT_LE(found.best->values[0], .052 * (1 + 2e-5));  // .05 + .002, and what rounding is granted
}

/// f of the planar hopper: composite inertia without the thigh's own, by parallel axes; knee and
/// ankle pitch in rad. Written from the document's numbers, not from its code.
double rest_inertia_kg_m2(double knee, double ankle) {
  struct Point {
    double mass, x, z;
  };
  const auto turned = [](double angle, double x, double z) {
    return std::pair{x * std::cos(angle) + z * std::sin(angle),
                     -x * std::sin(angle) + z * std::cos(angle)};
  };
  const auto [calf_x, calf_z] = turned(knee, 0, -.15);
  const auto [ankle_x, ankle_z] = turned(knee, 0, -.41);
  const auto [foot_x, foot_z] = turned(knee + ankle, .02, -.05);
  const Point points[] = {{7.6, 0, .22},
                          {3.89, calf_x, calf_z},
                          {.05, ankle_x, ankle_z},
                          {.91, ankle_x + foot_x, ankle_z + foot_z}};
  double mass = 0, x = 0, z = 0;
  for (const Point& point : points) {
    mass += point.mass;
    x += point.mass * point.x;
    z += point.mass * point.z;
  }
  double inertia = .06 + 1e-5 + .0035;
  for (const Point& point : points) {
    inertia += point.mass * (std::pow(point.x - x / mass, 2) + std::pow(point.z - z / mass, 2));
  }
  return inertia;
}

TEST(Hopper, HasTheInertiaOfItsParallelAxes) {
  const ReadRobot read = read_robot(kHopper);
  const auto knee = *read.robot.find_joint("knee");
  const auto ankle = *read.robot.find_joint("ankle_pitch");
  Posture posture{"", Eigen::VectorXd::Zero(3)};
  for (const auto& [q_knee, q_ankle] : {std::pair{.3, .2}, {1.5, -.5}, {2.2, .6}}) {
    posture.joints[static_cast<Eigen::Index>(knee) - 1] = q_knee;
    posture.joints[static_cast<Eigen::Index>(ankle) - 1] = q_ankle;
    EXPECT_NEAR(pitch_inertia_kg_m2(read.robot.tree, posture),
                .335 + rest_inertia_kg_m2(q_knee, q_ankle), 1e-13);
  }
}

// Seed 000: CAM 6.0, CAV 7.4 and 10.6, so inertias of 0.81 and 0.566; the reference's thigh of 0.13
// to 0.34 kg m2. Oracle: the thigh must make up what the rest lacks, so its range ends where the
// legs are straightest and most folded, found by a scan over the joints' ranges.
TEST(Hopper, LeavesTheValleyOfTheReference) {
  double most = 0;
  double least = 1e9;
  for (int i = 0; i <= 400; ++i) {
    for (int j = 0; j <= 400; ++j) {
      const double inertia = rest_inertia_kg_m2(2.2689280275926285 * i / 400,
                                                -.8726646259971648 + 1.5707963267948966 * j / 400);
      most = std::max(most, inertia);
      least = std::min(least, inertia);
    }
  }
  const ReadRobot read = read_robot(kHopper);
  ASSERT_EQ(read.robot.postures[1].name, "takeoff");
  ASSERT_EQ(read.robot.postures[2].name, "tuck");
  const Question question = question_of(
      read, 6.0, {{1, 7.4}, {2, 10.6}},
      {"/bodies/0/inertia_kg_m2/yy,/bodies/0/inertia_kg_m2/xx=0.05:0.45", "/postures/takeoff/knee",
       "/postures/takeoff/ankle_pitch", "/postures/tuck/knee", "/postures/tuck/ankle_pitch"});
  const std::optional<Candidate> best = nearest_candidate(question);
  ASSERT_TRUE(meets(question.figures, best));
  const std::vector<double> inertias = inertias_kg_m2(question, best->values);
  EXPECT_NEAR(inertias[0], .81, .01 * .81 + .005);
  EXPECT_NEAR(inertias[1], .566, .01 * .566 + .0005);
  const Profile thigh = profile_of(question, 0, best);
  ASSERT_EQ(thigh.ranges.size(), 1u);
  EXPECT_NEAR(thigh.ranges[0].low, 6.0 / 7.4 / 1.01 - most, 2e-4);
  EXPECT_NEAR(thigh.ranges[0].high, 6.0 / 10.6 / .99 - least, 2e-4);
  EXPECT_FALSE(thigh.is_determined);
  // The reference's range has two decimals and no tolerance.
  EXPECT_NEAR(6.0 / 7.4 - most, .13, .01);
  EXPECT_NEAR(6.0 / 10.6 - least, .34, .01);
}

// The assumed postures of the example go with its assumed thigh: rounded figures of the seed.
TEST(Hopper, MeetsThePublishedVelocitiesAsItStands) {
  const Robot robot = read_robot(kHopper).robot;
  EXPECT_NEAR(6.0 / pitch_inertia_kg_m2(robot.tree, robot.postures[1]), 7.4, .05);
  EXPECT_NEAR(6.0 / pitch_inertia_kg_m2(robot.tree, robot.postures[2]), 10.6, .05);
}

std::string refusal(const std::string& text) {
  const ReadRobot read = read_robot(kHopper);
  try {
    (void)free_value(text, read.documents.front(), read.robot);
    return "";
  } catch (const io::SpecError& error) {
    const std::string message = error.what();
    return message.substr(message.find(' ') + 1);
  }
}

TEST(FreeValue, HasPlausibleBounds) {
  const ReadRobot read = read_robot(kHopper);
  const auto bounds = [&](const char* text) {
    const FreeValue value = free_value(text, read.documents.front(), read.robot);
    return std::pair{value.lowest, value.highest};
  };
  EXPECT_EQ(bounds("/bodies/0/mass_kg"), (std::pair{3.8, 15.2}));
  EXPECT_EQ(bounds("/bodies/0/inertia_kg_m2/yy"), (std::pair{.335 / 4, .335 * 4}));
  EXPECT_EQ(bounds("/bodies/0/center_of_mass_m/2"), (std::pair{.22 - .1, .22 + .1}));
  EXPECT_EQ(bounds("/joints/1/position_m/2"), (std::pair{-.41 - .1, -.41 + .1}));
  EXPECT_EQ(bounds("/postures/tuck/knee"), (std::pair{0.0, 2.2689280275926285}));
  EXPECT_EQ(bounds("/postures/tuck/knee=1:2"), (std::pair{1.0, 2.0}));
}

TEST(FreeValue, RefusesWhatIsNone) {
  EXPECT_NE(refusal("bodies").find("is no JSON pointer"), std::string::npos);
  EXPECT_NE(refusal("/bodies/9/mass_kg").find("no number stands at"), std::string::npos);
  EXPECT_NE(refusal("/bodies/0/name").find("no number stands at"), std::string::npos);
  EXPECT_NE(refusal("/contacts/0/friction_coefficient").find("does not bear on"),
            std::string::npos);
  EXPECT_NE(refusal("/joints/0/speed_limit_rad_s").find("does not bear on"), std::string::npos);
  EXPECT_NE(refusal("/bodies/0/mass_kg,/bodies/1/mass_kg").find("only equal values"),
            std::string::npos);
  EXPECT_NE(refusal("/bodies/0/mass_kg=2").find("LOW:HIGH"), std::string::npos);
  EXPECT_NE(refusal("/bodies/0/mass_kg=2:nan").find("LOW:HIGH"), std::string::npos);
  EXPECT_NE(refusal("/bodies/0/mass_kg=1:1e308").find("beyond every robot"), std::string::npos);
  EXPECT_NE(refusal("/bodies/0/inertia_kg_m2/yy=-1e308:1e308").find("beyond every robot"),
            std::string::npos);
  EXPECT_NE(refusal("/bodies/0/mass_kg=3:2").find("is not below"), std::string::npos);
  EXPECT_NE(refusal("/bodies/0/mass_kg=-1:2").find("must be positive"), std::string::npos);
  EXPECT_NE(refusal("/postures/tuck/knee=-1:2").find("leaves the joint's range"),
            std::string::npos);
  EXPECT_EQ(refusal("/bodies/0/mass_kg=2:3"), "");
}

}  // namespace
}  // namespace torquewright::hopper::calibration
