// SPDX-License-Identifier: Apache-2.0
// What flat ground cannot do: hold what is not on it, give energy, push what slides. Oracles:
// Newton's law of a block whose motion is given in closed form, and projection onto the nearest
// friction of a block that slides.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "hopper/check/hopper_check.hpp"
#include "hopper/contact/sliding.hpp"
#include "hopper/motion/motion_reader.hpp"
#include "robot/model/robot_spec.hpp"

namespace torquewright::hopper::ground_laws {
namespace {

using actuator::Severity;
using Eigen::Index;

constexpr double kGravity = 9.81;
constexpr double kMass_kg = 7.0;
constexpr double kWeight_N = kMass_kg * kGravity;
constexpr double kFriction = 0.6;

/// On four feet, its centre of mass between them: forces along the ground do not tip it.
Robot block(double restitution = 0.0) {
  Robot robot;
  robot.tree.base = dynamics::BaseKind::kSpatial;
  dynamics::Body body;
  body.name = "block";
  body.inertia = {kMass_kg, {0, 0, 0}, 0.3 * Eigen::Matrix3d::Identity()};
  robot.tree.bodies.push_back(body);
  for (const double x : {0.1, -0.1}) {
    for (const double y : {0.15, -0.15}) {
      robot.contacts.push_back(
          {"foot" + std::to_string(robot.contacts.size()), {0, {x, y, 0}}, kFriction, restitution});
    }
  }
  return robot;
}

/// Along x and z.
struct State {
  double position_m[2];
  double velocity_m_s[2];
  double acceleration_m_s2[2];
};

void add(Motion& motion, double time_s, const State& state) {
  motion.times_s.push_back(time_s);
  const Index count = motion.samples();
  motion.positions.conservativeResize(7, count);
  motion.velocities.conservativeResize(6, count);
  motion.accelerations.conservativeResize(6, count);
  motion.positions.col(count - 1) << state.position_m[0], 0, state.position_m[1], 1, 0, 0, 0;
  motion.velocities.col(count - 1) << state.velocity_m_s[0], 0, state.velocity_m_s[1], 0, 0, 0;
  motion.accelerations.col(count - 1) << state.acceleration_m_s2[0], 0, state.acceleration_m_s2[1],
      0, 0, 0;
}

/// From x0 = 0, z0 at v0 with constant acceleration, 0.6 s at 4 ms.
Motion uniform(double height_m, State rates) {
  Motion motion;
  for (int i = 0; i <= 150; ++i) {
    const double t = 4e-3 * i;
    State state = rates;
    for (int axis : {0, 1}) {
      state.position_m[axis] = (axis == 1 ? height_m : 0.0) + rates.velocity_m_s[axis] * t +
                               0.5 * rates.acceleration_m_s2[axis] * t * t;
      state.velocity_m_s[axis] += rates.acceleration_m_s2[axis] * t;
    }
    add(motion, t, state);
  }
  return motion;
}

Motion said_to_touch(Motion motion) {
  motion.has_touching = true;
  motion.touching.setOnes(4, motion.samples());
  return motion;
}

std::vector<Finding> found(const Robot& robot, Motion motion, const std::string& rule,
                           const CheckOptions& options = {}) {
  std::vector<Finding> some;
  for (const Finding& finding : check_motion(robot, motion, options).check.findings) {
    if (finding.rule == rule) some.push_back(finding);
  }
  return some;
}

TEST(AboveTheGround, WhatStandsThereByItsFlagsAsksWhereTheGroundIs) {
  const Motion motion = said_to_touch(uniform(0.31, {}));
  const std::vector<Finding> findings = found(block(), motion, "contact-above-ground");
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_EQ(findings[0].severity, Severity::kWarning);
  EXPECT_NEAR(*findings[0].value, 0.31, 1e-12);
  EXPECT_NE(findings[0].sentence.find("--ground-height 0.31"), std::string::npos);
  CheckOptions known;
  known.contact.ground_height_m = 0.31;
  EXPECT_TRUE(found(block(), motion, "contact-above-ground", known).empty());
}

// 32 mm may be a foot's radius, or what --contact-height states in its place.
TEST(AboveTheGround, IsWhatIsHigherThanWhatCountsAsTouching) {
  const char* rule = "contact-above-ground";
  EXPECT_TRUE(found(block(), said_to_touch(uniform(0.0319, {})), rule).empty());
  EXPECT_EQ(found(block(), said_to_touch(uniform(0.0321, {})), rule).size(), 1u);
  CheckOptions stated;
  stated.contact.height_m = 0.01;
  EXPECT_TRUE(found(block(), said_to_touch(uniform(0.0099, {})), rule, stated).empty());
  EXPECT_EQ(found(block(), said_to_touch(uniform(0.0101, {})), rule, stated).size(), 1u);
}

// m (g + a) lifts it; no ground at one height does.
TEST(AboveTheGround, WhatRisesOnItsContactsIsAViolation) {
  const Motion motion = said_to_touch(uniform(0.0, {{}, {}, {0, 4.0}}));
  const std::vector<Finding> findings = found(block(), motion, "contact-above-ground");
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_EQ(findings[0].severity, Severity::kViolation);
  EXPECT_NEAR(*findings[0].value, 0.5 * 4.0 * 0.6 * 0.6, 1e-9);
  EXPECT_NE(findings[0].sentence.find(fmt::format("{:.4g} N", kMass_kg * (kGravity + 4.0))),
            std::string::npos);
}

TEST(AboveTheGround, FlagsOfWhatFliesCarryNothing) {
  const Motion motion = said_to_touch(uniform(1.0, {{}, {0, 2.0}, {0, -kGravity}}));
  EXPECT_TRUE(found(block(), motion, "contact-above-ground").empty());
}

TEST(AboveTheGround, LeavesTheVerdictOpen) {
  const std::filesystem::path specs = std::filesystem::path(TORQUEWRIGHT_SOURCE_DIR) / "specs";
  const ReadRobot read = read_robot(specs / "robot/hopper.json");
  MotionFile source;
  source.file = specs / "trajectory/hopper_squat.csv";
  Motion motion = said_to_touch(read_motion(read.robot, source));
  motion.positions.row(2).array() += 0.27;
  Motion again = motion;
  EXPECT_EQ(check_motion(read.robot, motion, {}).check.verdict, actuator::Verdict::kUndecided);
  CheckOptions known;
  known.contact.ground_height_m = 0.27;
  EXPECT_EQ(check_motion(read.robot, again, known).check.verdict, actuator::Verdict::kPass);
}

struct Fall {
  Motion motion;
  double speed_m_s;
};

/// Falls from 0.2 m while it moves at `along`, leaves at `share` of its speed and `after` along,
/// with two rows at the impact,
/// where it touches; 2 ms.
Fall bounce(double share, double along_m_s = 0.0, double after_m_s = 0.0) {
  Fall fall{{}, std::sqrt(2.0 * kGravity * 0.2)};
  const double touch_s = fall.speed_m_s / kGravity;
  for (int i = 0; i <= 100; ++i) {
    const double t = touch_s * i / 100;
    add(fall.motion, t,
        {{along_m_s * t, 0.2 - 0.5 * kGravity * t * t},
         {along_m_s, -kGravity * t},
         {0, -kGravity}});
  }
  fall.motion.breaks.push_back(fall.motion.samples());
  const double up_m_s = share * fall.speed_m_s;
  const double free = share > 0.0 ? 1.0 : 0.0;  // else it stays on the ground
  for (int i = 0; i <= 50; ++i) {
    const double t = 2e-3 * i;
    add(fall.motion, touch_s + t,
        {{along_m_s * touch_s + after_m_s * t, up_m_s * t - 0.5 * free * kGravity * t * t},
         {after_m_s, up_m_s - free * kGravity * t},
         {0, -free * kGravity}});
  }
  fall.motion.has_touching = true;
  fall.motion.touching.setZero(4, fall.motion.samples());
  fall.motion.touching.middleCols(100, share > 0.0 ? 2 : 52).setOnes();
  return fall;
}

// m v^2 (f^2 - 1)/2.
TEST(ImpactEnergy, ThatTheGroundGivesIsAViolation) {
  const Fall fall = bounce(1.3);
  const std::vector<Finding> findings = found(block(1.0), fall.motion, "impact-energy");
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_EQ(findings[0].severity, Severity::kViolation);
  EXPECT_NEAR(*findings[0].value,
              0.5 * kMass_kg * fall.speed_m_s * fall.speed_m_s * (1.3 * 1.3 - 1.0), 1e-6);
  EXPECT_TRUE(found(block(1.0), bounce(1.0).motion, "impact-energy").empty());
  EXPECT_TRUE(found(block(1.0), bounce(0.7).motion, "impact-energy").empty());
}

// The speed afterwards is known to 0.1 m/s, which counts as touching, and two steps of gravity.
TEST(ImpactRebound, IsNoFasterThanTheRestitutionLetsIt) {
  const Fall fall = bounce(0.5);
  const std::vector<Finding> findings = found(block(0.3), fall.motion, "impact-rebound");
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_EQ(findings[0].severity, Severity::kViolation);
  EXPECT_NEAR(*findings[0].value, 0.5 * fall.speed_m_s, 1e-6);
  const double steps_m_s = kGravity * (fall.speed_m_s / kGravity / 100 + 2e-3);
  EXPECT_NEAR(*findings[0].limit, 0.3 * fall.speed_m_s + 0.1 + steps_m_s, 1e-6);
  EXPECT_TRUE(found(block(0.3), fall.motion, "impact-energy").empty());
  EXPECT_TRUE(found(block(0.5), fall.motion, "impact-rebound").empty());
  EXPECT_TRUE(found(block(0.0), bounce(0.0).motion, "impact-rebound").empty());
}

// Thrown back within an impact of two rows, feet touch whether the file says so or not: m v (1 +
// f).
TEST(ImpactRebound, IsFoundWithoutFlagsOfContact) {
  Fall fall = bounce(0.5);
  fall.motion.has_touching = false;
  Motion again = fall.motion;
  EXPECT_EQ(found(block(0.3), fall.motion, "impact-rebound").size(), 1u);
  EXPECT_TRUE(found(block(0.5), fall.motion, "impact-rebound").empty());
  const HopperReport report = check_motion(block(0.5), again, {});
  ASSERT_EQ(report.demand.jolts.size(), 1u);
  double normal_N_s = 0.0;
  for (int i = 0; i < 4; ++i) normal_N_s += report.demand.jolts[0].impulses_N_s[3 * i + 2];
  EXPECT_NEAR(normal_N_s, 1.5 * kMass_kg * fall.speed_m_s, 1e-6);
}

TEST(FrictionSliding, InAnImpactPushesNothingAlong) {
  const std::vector<Finding> pushed =
      found(block(), bounce(0.0, 1.1, 1.1 + 0.8).motion, "friction-sliding");
  ASSERT_GE(pushed.size(), 1u);
  EXPECT_EQ(pushed[0].severity, Severity::kViolation);
  EXPECT_EQ(pushed[0].unit, "N s");
  EXPECT_NEAR(*pushed[0].value, kMass_kg * 0.8, 1e-6);
  for (const Finding& one :
       found(block(), bounce(0.0, 1.1, 1.1 - 0.8).motion, "friction-sliding")) {
    EXPECT_NE(one.unit, "N s");
  }
}

Motion slide(double speed_m_s, double acceleration_m_s2) {
  return uniform(0.0, {{}, {speed_m_s, 0}, {acceleration_m_s2, 0}});
}

/// The force that is left, in weights, where p weights brake and the least that friction brakes
/// with is c of the normal force: the distance of (-p, 1) from the ray along (-c, 1).
double left_share(double braked) {
  const double least = kFriction / std::sqrt(2.0);
  return (least - braked) / std::sqrt(1.0 + least * least);
}

TEST(FrictionSliding, BrakesWhatSlides) {
  const Robot robot = block();
  const auto sliding = [&](double share, double speed_m_s = 2.9) {
    return found(robot, slide(speed_m_s, -share * kGravity), "friction-sliding");
  };
  EXPECT_TRUE(sliding(kFriction, 4.0).empty());
  for (const double share : {0.0, 0.3, -0.3}) {
    const std::vector<Finding> findings = sliding(share);
    ASSERT_EQ(findings.size(), 1u) << share;
    EXPECT_EQ(findings[0].severity, Severity::kViolation);
    EXPECT_NEAR(*findings[0].value, left_share(share) * kWeight_N, 1e-3 * kWeight_N) << share;
  }
  // The limit of what may be left, 0.1 weights, lies between 0.3 and 0.33.
  EXPECT_LT(left_share(0.33), 0.1);
  EXPECT_TRUE(sliding(0.33).empty());
  EXPECT_NE(sliding(-0.3)[0].sentence.find("push it along"), std::string::npos);
}

// What moves no faster than what counts as touching may creep.
TEST(FrictionSliding, IsFasterThanWhatCountsAsTouching) {
  EXPECT_TRUE(found(block(), slide(0.09, 0.0), "friction-sliding").empty());
  EXPECT_EQ(found(block(), slide(0.11, 0.0), "friction-sliding").size(), 1u);
  CheckOptions stated;
  stated.contact.speed_m_s = 0.2;
  EXPECT_TRUE(found(block(), slide(0.11, 0.0), "friction-sliding", stated).empty());
}

// 0.2 weights push along what friction would brake with at least c = 0.6/sqrt(2).
TEST(FrictionSliding, IsOfTheFilesForcesToo) {
  Motion motion = slide(1.7, 0.2 * kGravity);
  motion.has_forces = true;
  motion.forces_N.setZero(12, motion.samples());
  for (Index i = 0; i < 4; ++i) {
    motion.forces_N.row(3 * i).setConstant(0.2 * kWeight_N / 4);
    motion.forces_N.row(3 * i + 2).setConstant(kWeight_N / 4);
  }
  const std::vector<Finding> findings = found(block(), motion, "friction-sliding");
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_NEAR(*findings[0].value, (0.2 + kFriction / std::sqrt(2.0)) * kWeight_N, 1e-6);
}

// MuJoCo's law of a constraint, a1 = (1 - d) a0 + d (-b u) with b = 2/(0.95 T), d = 0.9 and
// a0 = a1 + F w: what friction takes off.
TEST(FrictionSliding, LeavesCreepToSoftGround) {
  const double time_constant_s = 0.03;
  const double friction_N = 120.0;
  const double inverse_mass_1_kg = 4.0;
  for (const double braked_m_s2 : {0.0, 7.0}) {
    const double speed_m_s = creep_m_s(time_constant_s, friction_N, inverse_mass_1_kg, braked_m_s2);
    const double free_m_s2 = -braked_m_s2 + friction_N * inverse_mass_1_kg;
    const double b = 2.0 / (0.95 * time_constant_s);
    EXPECT_NEAR(-braked_m_s2, 0.1 * free_m_s2 - 0.9 * b * speed_m_s, 1e-9);
  }
}

}  // namespace
}  // namespace torquewright::hopper::ground_laws
