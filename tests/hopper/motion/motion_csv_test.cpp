// SPDX-License-Identifier: Apache-2.0
// A motion written and read again. Oracle: the motion itself, number by number: the format is one
// that both ends must agree on.
#include "hopper/motion/motion_csv.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "hopper/motion/motion_reader.hpp"
#include "robot/model/robot_spec.hpp"
#include "tests/io/scratch_folder.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;

Robot robot_of(const std::string& name) {
  return read_robot(TORQUEWRIGHT_SOURCE_DIR "/specs/robot/" + name + ".json").robot;
}

constexpr Index kSamples = 7;
constexpr Index kImpact = 4;

/// Numbers that use all digits; positions drift slowly, as a reader wants angles to.
Eigen::MatrixXd table(Index rows, double size, std::mt19937& random) {
  std::uniform_real_distribution<double> draw(-size, size);
  return Eigen::MatrixXd::NullaryExpr(rows, kSamples, [&] { return draw(random); });
}

/// All that a motion may hold, with an impact: two rows of one time and position.
Motion full_motion(const Robot& robot) {
  std::mt19937 random(7);
  const auto joints = static_cast<Index>(robot.tree.bodies.size()) - 1;
  const auto contacts = static_cast<Index>(robot.contacts.size());
  Motion motion;
  for (Index i = 0; i < kSamples; ++i) {
    const Index step = i < kImpact ? i : i - 1;
    motion.times_s.push_back(static_cast<double>(step) / 3.0);
  }
  motion.positions = table(robot.tree.position_size(), 1.0, random);
  if (robot.tree.base == dynamics::BaseKind::kSpatial) {
    for (Index i = 0; i < kSamples; ++i) motion.positions.col(i).segment<4>(3).normalize();
  }
  motion.positions.col(kImpact) = motion.positions.col(kImpact - 1);
  motion.velocities = table(robot.tree.velocity_size(), 1e3, random);
  motion.accelerations = table(robot.tree.velocity_size(), 1e-9, random);
  motion.efforts = table(joints, 300.0, random);
  motion.has_effort.assign(static_cast<std::size_t>(joints), true);
  motion.forces_N = table(3 * contacts, 1e5, random);
  motion.has_forces = true;
  motion.touching = (table(contacts, 1.0, random).array() > 0.0).cast<double>();
  motion.has_touching = true;
  motion.ground = {{0.3}, {0.0, 0.085}};
  return motion;
}

Motion read_again(const Robot& robot, const Motion& motion) {
  const test::ScratchFolder folder;
  return read_motion(robot, {folder.write("motion.csv", motion_csv(robot, motion)), {}, {}, {}});
}

class MotionCsv : public testing::TestWithParam<const char*> {};

TEST_P(MotionCsv, IsReadAsTheSameNumbers) {
  const Robot robot = robot_of(GetParam());
  const Motion motion = full_motion(robot);
  const Motion again = read_again(robot, motion);
  EXPECT_EQ(again.times_s, motion.times_s);
  EXPECT_EQ(again.positions, motion.positions);
  EXPECT_EQ(again.velocities, motion.velocities);
  EXPECT_EQ(again.accelerations, motion.accelerations);
  EXPECT_EQ(again.efforts, motion.efforts);
  EXPECT_EQ(again.has_effort, motion.has_effort);
  EXPECT_EQ(again.forces_N, motion.forces_N);
  EXPECT_EQ(again.touching, motion.touching);
  EXPECT_EQ(again.ground.edges_x_m, motion.ground.edges_x_m);
  EXPECT_EQ(again.ground.heights_m, motion.ground.heights_m);
  EXPECT_TRUE(again.has_base);
  EXPECT_EQ(again.has_forces, !robot.contacts.empty());
  EXPECT_EQ(again.has_touching, !robot.contacts.empty());
  EXPECT_EQ(again.velocity_origin, Origin::kGiven);
  EXPECT_EQ(again.acceleration_origin, Origin::kGiven);
  EXPECT_EQ(again.breaks, std::vector<Index>{kImpact});
}

// A spatial base with its quaternion, a planar one, one without contact points.
INSTANTIATE_TEST_SUITE_P(Robots, MotionCsv, testing::Values("hopper", "rabbit", "cassie"));

TEST(MotionCsv, LeavesOutWhatIsDerivedOrNotThere) {
  const Robot robot = robot_of("hopper");
  Motion motion = full_motion(robot);
  // Without velocities of its own a motion cannot tell an impact from a row that stands twice.
  motion.times_s[kImpact] = 0.5 * (motion.times_s[kImpact - 1] + motion.times_s[kImpact + 1]);
  motion.velocity_origin = Origin::kDerived;
  motion.acceleration_origin = Origin::kDerived;
  motion.has_effort = {true, false, true};
  motion.has_forces = false;
  motion.has_touching = false;
  const Motion again = read_again(robot, motion);
  EXPECT_EQ(again.positions, motion.positions);
  EXPECT_EQ(again.velocity_origin, Origin::kAbsent);
  EXPECT_EQ(again.acceleration_origin, Origin::kAbsent);
  EXPECT_EQ(again.has_effort, motion.has_effort);
  EXPECT_EQ(again.efforts.row(2), motion.efforts.row(2));
  EXPECT_FALSE(again.has_forces || again.has_touching);
}

// Oracle: the length of a rotation's quaternion; three decimals leave 1 within 1e-3.
TEST(MotionCsv, RefusesQuaternionsThatAreNoRotations) {
  const Robot robot = robot_of("hopper");
  for (const double length : {0.98, 0.995, 1.005, 1.02, 2.0}) {
    Motion motion = full_motion(robot);
    motion.positions.col(2).segment<4>(3) *= length;
    if (std::abs(length - 1.0) < 1e-2) {
      EXPECT_NO_THROW(read_again(robot, motion)) << length;
      continue;
    }
    try {
      (void)read_again(robot, motion);
      ADD_FAILURE() << "was read: " << length;
    } catch (const io::SpecError& error) {
      EXPECT_NE(std::string(error.what()).find("the base's quaternion has the length"),
                std::string::npos)
          << error.what();
    }
  }
}

TEST(MotionCsv, RefusesFlagsBetweenTouchingAndNot) {
  const Robot robot = robot_of("hopper");
  for (const double flag : {-3.0, 0.4, 2.0}) {
    Motion motion = full_motion(robot);
    motion.touching(1, 3) = flag;
    try {
      (void)read_again(robot, motion);
      ADD_FAILURE() << "was read: " << flag;
    } catch (const io::SpecError& error) {
      EXPECT_NE(std::string(error.what()).find("must be 1 where the point touches, else 0"),
                std::string::npos)
          << error.what();
    }
  }
}

TEST(MotionCsv, OfAFloatingBaseHasNoBase) {
  const Robot robot = robot_of("hopper");
  Motion motion = full_motion(robot);
  motion.has_base = false;
  const std::string text = motion_csv(robot, motion);
  EXPECT_EQ(text.find("base_"), std::string::npos);
  EXPECT_FALSE(read_again(robot, motion).has_base);
}

TEST(MotionCsv, RefusesWhatIsNoNumber) {
  const Robot robot = robot_of("hopper");
  Motion motion = full_motion(robot);
  motion.velocities(2, 3) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(motion_csv(robot, motion), std::invalid_argument);
}

}  // namespace
}  // namespace torquewright::hopper
