// SPDX-License-Identifier: Apache-2.0
// What is no motion. Oracles: calculus (a rate that is scaled, turned or another's is none), and
// conservation: a body in the air keeps its angular momentum and falls.
#include "hopper/check/physical.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>

#include "hopper/check/hopper_check.hpp"
#include "hopper/motion/motion_reader.hpp"
#include "hopper/motion/rate_agreement.hpp"
#include "io/faults/spec_error.hpp"
#include "robot/model/robot_spec.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;

constexpr double kToDegrees = 180.0 / std::numbers::pi;

class FlipRates : public testing::Test {
 protected:
  static constexpr Index kKneeRate = 6;
  Robot robot = read_robot(TORQUEWRIGHT_SOURCE_DIR "/specs/robot/hopper.json").robot;
  Motion motion =
      read_motion(robot, {TORQUEWRIGHT_SOURCE_DIR "/specs/trajectory/hopper_flip.csv", {}, {}, {}});

  std::string refusal() {
    try {
      require_rates_agree(robot, motion);
    } catch (const io::SpecError& error) {
      return error.what();
    }
    return "";
  }
  void expect_refusal(const char* cause) {
    EXPECT_NE(refusal().find(cause), std::string::npos) << refusal();
  }
};

TEST_F(FlipRates, Agree) { EXPECT_EQ(refusal(), ""); }

TEST_F(FlipRates, OfMillisecondsAreNone) {
  for (double& time_s : motion.times_s) time_s *= 1e3;
  expect_refusal("time_s seems to be in milliseconds");
  const auto found = rate_mismatches(robot, motion);
  ASSERT_EQ(found.size(), 5u);  // x, z, pitch, knee, ankle pitch; the others stand
  for (const RateMismatch& one : found) EXPECT_NEAR(one.factor, 1000, 10) << one.coordinate;
}

TEST_F(FlipRates, InDegreesOrBackwardsAreNone) {
  motion.velocities.row(kKneeRate) *= kToDegrees;
  expect_refusal("the velocity of knee is not the rate of its position");
  expect_refusal("it seems to be in degrees");
  motion.velocities.row(kKneeRate) /= -kToDegrees;
  expect_refusal("its sign seems to be the other way round");
  motion.velocities.row(kKneeRate) *= -1.0;
  motion.positions.row(motion.positions.rows() - 3) *= kToDegrees;
  expect_refusal("what it is the rate of seems to be in degrees");
}

TEST_F(FlipRates, OfAnotherJointAreNone) {
  motion.velocities.row(kKneeRate).swap(motion.velocities.row(kKneeRate + 1));
  expect_refusal("another column's, another joint's, or late");
}

TEST_F(FlipRates, OfVelocitiesAreAskedToo) {
  motion.accelerations *= -1.0;
  expect_refusal(
      "the acceleration of base_x, base_z, base_angular_y, knee, ankle_pitch is not the "
      "rate of its velocity");
}

// Just inside and just outside of a quarter of the larger one (and a tenth of the rms).
TEST_F(FlipRates, MayBeOffByAQuarter) {
  motion.acceleration_origin = Origin::kAbsent;
  const Eigen::MatrixXd velocities = motion.velocities;
  motion.velocities.row(kKneeRate) = 1.25 * velocities.row(kKneeRate);
  EXPECT_EQ(refusal(), "");
  motion.velocities.row(kKneeRate) = 1.8 * velocities.row(kKneeRate);
  expect_refusal("it seems to be scaled by 1.8");
}

// Encoders of 14 bits and gyroscopes of 0.02 rad/s: noise is no mistake.
TEST_F(FlipRates, MayBeNoisy) {
  std::mt19937 random(3);
  std::normal_distribution<double> position(0.0, 4e-4), velocity(0.0, 0.02);
  for (Index i = 0; i < motion.samples(); ++i) {
    for (Index row = 0; row < 3; ++row) {
      motion.positions(motion.positions.rows() - 3 + row, i) += position(random);
      motion.velocities(kKneeRate + row, i) += velocity(random);
    }
  }
  motion.acceleration_origin = Origin::kAbsent;
  EXPECT_EQ(refusal(), "");
}

/// A body of 4 kg and 0.2 kg m2 that turns about every axis in free fall, rates in the world's or
/// in its own axes.
TEST(Rates, OfABaseAreInItsOwnAxes) {
  Robot robot;
  robot.tree.base = dynamics::BaseKind::kSpatial;
  robot.tree.bodies.resize(1);
  Motion motion;
  for (int i = 0; i < 200; ++i) motion.times_s.push_back(5e-3 * i);
  motion.positions.setZero(7, motion.samples());
  motion.velocities.setZero(6, motion.samples());
  motion.acceleration_origin = Origin::kAbsent;
  Eigen::Quaterniond R(Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()));
  Eigen::MatrixXd in_world(3, motion.samples());
  for (Index i = 0; i < motion.samples(); ++i) {
    const double t = motion.time_s(i);
    const Eigen::Vector3d own(3 * std::cos(2 * t), 4 * std::sin(3 * t), 2.0);
    motion.positions.block<4, 1>(3, i) << R.w(), R.x(), R.y(), R.z();
    motion.velocities.block<3, 1>(3, i) = own;
    in_world.col(i) = R * own;
    const Eigen::Vector3d middle(3 * std::cos(2 * t + 5e-3), 4 * std::sin(3 * t + 7.5e-3), 2.0);
    R = R * Eigen::Quaterniond(Eigen::AngleAxisd(5e-3 * middle.norm(), middle.normalized()));
  }
  EXPECT_TRUE(rate_mismatches(robot, motion).empty());
  motion.velocities.bottomRows(3) = in_world;
  const auto found = rate_mismatches(robot, motion);
  ASSERT_FALSE(found.empty());
  for (const RateMismatch& one : found) {
    EXPECT_EQ(one.likely_cause, "it seems to be in the world's axes; the base's are asked for");
  }
}

/// A brick of 10 kg and 0.4 kg m2 about y that turns at 15 rad/s (6 Nm s) in the air for 0.5 s, its
/// rates each other's: spun up and pulled down by what nothing gives.
Motion flight(double spin_rad_s2, double gravity_m_s2, double gap_s = 0.0) {
  Motion motion;
  for (int i = 0; i <= 500; ++i) motion.times_s.push_back(1e-3 * i + (i > 250 ? gap_s : 0.0));
  motion.positions.setZero(3, motion.samples());
  motion.velocities.setZero(3, motion.samples());
  motion.accelerations.setZero(3, motion.samples());
  for (Index i = 0; i < motion.samples(); ++i) {
    const double t = motion.time_s(i);
    motion.positions.col(i) << t, 3 + 2 * t - 0.5 * gravity_m_s2 * t * t,
        15 * t + 0.5 * spin_rad_s2 * t * t;
    motion.velocities.col(i) << 1, 2 - gravity_m_s2 * t, 15 + spin_rad_s2 * t;
    motion.accelerations.col(i) << 0, -gravity_m_s2, spin_rad_s2;
  }
  motion.file = "flight.csv";
  return motion;
}

std::string refusal_of(Motion motion, double residual_share = 0.1) {
  Robot robot;
  robot.tree.base = dynamics::BaseKind::kPlanar;
  dynamics::Body brick;
  brick.inertia = {10.0, Eigen::Vector3d::Zero(), 0.4 * Eigen::Matrix3d::Identity()};
  robot.tree.bodies = {brick};
  robot.contacts.push_back({"corner", {0, {0.1, 0, -0.1}}, 0.6, 0});
  CheckOptions options;
  options.residual_share = residual_share;
  try {
    check_motion(robot, motion, options);
  } catch (const io::SpecError& error) {
    return error.what();
  }
  return "";
}

// A flight of which nobody has seen a part, between t = 0.25 s and a step more. Where its rates are
// stated it is judged, and the gap is said; where they are derived a gap of more than 0.1 s is
// refused.
TEST(TimeGap, IsSaidAndNothingIsDifferentiatedAcrossIt) {
  for (const double gap_s : {0.0, 0.018, 0.02, 0.098, 0.1, 5.0}) {
    Motion stated = flight(0.0, 9.81, gap_s);
    Motion derived = stated;
    derived.acceleration_origin = Origin::kAbsent;
    Robot robot;
    robot.tree.base = dynamics::BaseKind::kPlanar;
    dynamics::Body brick;
    brick.inertia = {10.0, Eigen::Vector3d::Zero(), 0.4 * Eigen::Matrix3d::Identity()};
    robot.tree.bodies = {brick};
    const auto findings = check_motion(robot, stated, {}).check.findings;
    const auto gap = std::find_if(findings.begin(), findings.end(),
                                  [](const auto& one) { return one.rule == "time-gap"; });
    ASSERT_EQ(gap != findings.end(), gap_s > 0.019) << gap_s;
    if (gap != findings.end()) {
      EXPECT_EQ(gap->severity, actuator::Severity::kWarning);
      EXPECT_NEAR(*gap->time_s, 0.25, 1e-12);
      EXPECT_NEAR(*gap->value, gap_s + 1e-3, 1e-12);
    }
    const std::string refused = refusal_of(derived);
    EXPECT_EQ(refused != "", gap_s > 0.099) << gap_s << refused;
    if (gap_s != 5.0) continue;
    EXPECT_NE(refused.find("no samples for 5.001 s from t = 0.25 s on"), std::string::npos);
    EXPECT_NE(refused.find("accelerations are differentiated across them"), std::string::npos);
    EXPECT_NE(refused.find("with --until 0.25 and with --from 5.251"), std::string::npos)
        << refused;
  }
}

/// What is said of the squat, in which a flat foot stands all the time, where the file denies that.
std::string refusal_of_squat(const std::function<void(Motion&, Index contacts)>& deny) {
  const Robot robot = read_robot(TORQUEWRIGHT_SOURCE_DIR "/specs/robot/hopper.json").robot;
  Motion motion = read_motion(
      robot, {TORQUEWRIGHT_SOURCE_DIR "/specs/trajectory/hopper_squat.csv", {}, {}, {}});
  deny(motion, static_cast<Index>(robot.contacts.size()));
  try {
    check_motion(robot, motion, {});
  } catch (const io::SpecError& error) {
    return error.what();
  }
  return "";
}

// Heights and speeds do not count where the file says what touches.
TEST(Contacts, ThatTheFileDeniesAreNamedAsItsOwn) {
  const std::string flags = refusal_of_squat([](Motion& motion, Index contacts) {
    motion.has_touching = true;
    motion.touching.setZero(contacts, motion.samples());
  });
  EXPECT_NE(flags.find("the file's contact flags say that it does not (take these columns out"),
            std::string::npos)
      << flags;
  EXPECT_EQ(flags.find("--contact-height"), std::string::npos) << flags;
  const std::string forces = refusal_of_squat([](Motion& motion, Index contacts) {
    motion.has_forces = true;
    motion.forces_N.setZero(3 * contacts, motion.samples());
  });
  EXPECT_NE(forces.find("the file's contact forces say that it does not"), std::string::npos)
      << forces;
  EXPECT_EQ(forces.find("--contact-height"), std::string::npos) << forces;
}

// Oracle: momentum. The squat begins and ends at rest, so that the ground carries the weight on
// average, whatever the accelerations are.
TEST(Contacts, WhoseForcesCarryAnotherWeightAreRefused) {
  const Robot robot = read_robot(TORQUEWRIGHT_SOURCE_DIR "/specs/robot/hopper.json").robot;
  Motion squat = read_motion(
      robot, {TORQUEWRIGHT_SOURCE_DIR "/specs/trajectory/hopper_squat.csv", {}, {}, {}});
  const double weight_N = check_motion(robot, squat, {}).demand.weight_N;
  const auto carrying = [&](double weights) {
    return refusal_of_squat([&](Motion& motion, Index contacts) {
      motion.has_forces = true;
      motion.forces_N.setZero(3 * contacts, motion.samples());
      const double each_N = weights * weight_N / static_cast<double>(contacts);
      for (Index row = 2; row < 3 * contacts; row += 3)
        motion.forces_N.row(row).setConstant(each_N);
    });
  };
  EXPECT_EQ(carrying(1.0), "");
  EXPECT_EQ(carrying(1.08), "");
  for (const double weights : {10.0, 1.2, 0.8}) {
    const std::string said = carrying(weights);
    EXPECT_NE(said.find("the file's contact forces carry"), std::string::npos) << weights << said;
  }
}

// Radius of gyration sqrt(0.6/10): 1 % of 98.1 N at 0.245 m make 0.12 Nm s in 0.5 s, 2 % of 6 Nm s
// are as much: the mean is half of the gain away, so 0.24 Nm s may be gained.
TEST(Flight, ThatGainsMomentumIsRefused) {
  EXPECT_EQ(refusal_of(flight(0.0, 9.81)), "");
  EXPECT_EQ(refusal_of(flight(0.22 / 0.4 / 0.5, 9.81)), "");
  const std::string little = refusal_of(flight(0.28 / 0.4 / 0.5, 9.81));
  EXPECT_NE(little.find("flight.csv: t = 0 to 0.5 s: in flight the angular momentum"),
            std::string::npos)
      << little;
  EXPECT_NE(refusal_of(flight(0.86 / 0.4 / 0.5, 9.81)).find("moves by 0.43 Nm s"),
            std::string::npos);
  EXPECT_EQ(refusal_of(flight(0.28 / 0.4 / 0.5, 9.81), 0.2), "");  // asked for
}

TEST(Flight, ThatFallsOtherwiseIsRefused) {
  EXPECT_EQ(refusal_of(flight(0.0, 9.81 + 0.09)), "");
  EXPECT_NE(refusal_of(flight(0.0, 9.81 + 0.11)).find("does not fall freely"), std::string::npos);
  const std::string wrong = refusal_of(flight(0.0, 9.81 - 0.9));
  EXPECT_NE(wrong.find("0.9 m/s^2 (9.17 % of gravity; limit 0.0981)"), std::string::npos) << wrong;
  EXPECT_NE(refusal_of(flight(0.0, -9.81)).find("z points down"), std::string::npos);
}

// Noise of 0.1 mm and 0.02 rad/s: limits grow with what the samples themselves scatter.
TEST(Flight, IsNotRefusedForItsNoise) {
  std::mt19937 random(5);
  std::normal_distribution<double> place(0.0, 1e-4), spin(0.0, 0.02);
  Motion motion = flight(0.0, 9.81);
  for (Index i = 0; i < motion.samples(); ++i) {
    motion.positions(1, i) += place(random);
    motion.velocities(2, i) += spin(random);
  }
  EXPECT_EQ(refusal_of(motion), "");
}

}  // namespace
}  // namespace torquewright::hopper
