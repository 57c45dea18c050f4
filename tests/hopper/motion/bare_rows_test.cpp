// SPDX-License-Identifier: Apache-2.0
// Motions without a header. Oracle: the same numbers in a file with one.
#include "hopper/motion/bare_rows.hpp"

#include <gtest/gtest.h>

#include "hopper/motion/motion_reader.hpp"
#include "io/faults/spec_error.hpp"
#include "robot/model/robot_spec.hpp"
#include "tests/io/scratch_folder.hpp"

namespace torquewright::hopper {
namespace {

Robot robot_named(const std::string& name) {
  return read_robot(TORQUEWRIGHT_SOURCE_DIR "/specs/robot/" + name + ".json").robot;
}

Motion read(const Robot& robot, const std::string& text, const BareRows& bare) {
  const test::ScratchFolder folder;
  return read_motion(robot, {folder.write("motion.csv", text), {}, {}, {}, bare});
}

std::string refusal(const Robot& robot, const std::string& text, const BareRows& bare) {
  try {
    (void)read(robot, text, bare);
  } catch (const io::SpecError& error) {
    return error.what();
  }
  return "";
}

constexpr const char* kRetargeted =
    "0.1,0.2,1.5,0,0,0.6,0.8,0.3,0.01,-0.02\n"
    "0.2,0.2,1.4,0,0,-0.8,0.6,0.4,0.02,-0.03\n"
    "0.3,0.2,1.3,0,1,0,0,0.5,0.03,-0.04\n";

TEST(BareRows, AreTheRowsOfAFileWithAHeader) {
  const Robot robot = robot_named("hopper");
  const Motion bare = read(robot, kRetargeted, {{"base", "quaternion_xyzw", "joints"}, 50.0});
  std::string headed =
      "base_x_position_m,base_y_position_m,base_z_position_m,base_qx_position,base_qy_position,"
      "base_qz_position,base_qw_position,knee_position_rad,ankle_pitch_position_rad,"
      "ankle_roll_position_rad,time_s\n";
  headed +=
      "0.1,0.2,1.5,0,0,0.6,0.8,0.3,0.01,-0.02,0\n0.2,0.2,1.4,0,0,-0.8,0.6,0.4,0.02,-0.03,0.02\n"
      "0.3,0.2,1.3,0,1,0,0,0.5,0.03,-0.04,0.04\n";
  const Motion twin = read(robot, headed, {});
  EXPECT_EQ(bare.times_s, twin.times_s);
  EXPECT_EQ(bare.positions, twin.positions);
  EXPECT_TRUE(bare.has_base);
}

TEST(BareRows, MayStandInAnyOrderWithTimesAndColumnsThatDoNotCount) {
  const Robot robot = robot_named("rabbit");
  std::vector<std::string> order{"time", "skip", "pitch", "base", "joints", "skip"};
  std::string row = ",9,0.1,1,2", more;
  for (std::size_t i = 1; i < robot.tree.bodies.size(); ++i) more += ",0." + std::to_string(i);
  const Motion motion =
      read(robot, "0.5" + row + more + ",7\n1.5" + row + more + ",8\n", {order, 0.0});
  EXPECT_EQ(motion.samples(), 2);
  EXPECT_EQ(motion.positions.col(1).head<3>(), Eigen::Vector3d(1, 2, 0.1));
  EXPECT_EQ(motion.positions(4, 0), 0.2);
}

TEST(BareRows, AreRefusedByTheWordThatIsWrong) {
  const Robot robot = robot_named("hopper");
  const auto said = [&](const std::vector<std::string>& order, double fps) {
    return refusal(robot, kRetargeted, {order, fps});
  };
  EXPECT_NE(said({"base", "quaternion_xyzw", "joint"}, 50).find("did you mean \"joints\"?"),
            std::string::npos);
  EXPECT_NE(said({"base", "pitch", "joints"}, 50).find("\"pitch\": the robot has none"),
            std::string::npos);
  EXPECT_NE(said({"base", "quaternion_xyzw", "joints"}, 0).find("state --fps"), std::string::npos);
  EXPECT_NE(said({"time", "base", "quaternion_xyzw", "joints"}, 50).find("one of both"),
            std::string::npos);
  EXPECT_NE(said({"base", "quaternion_xyzw", "joints", "knee"}, 50).find("stands twice"),
            std::string::npos);
  EXPECT_NE(said({"base", "quaternion_xyzw", "joints", "skip"}, 50).find("cells"),
            std::string::npos);
}

}  // namespace
}  // namespace torquewright::hopper
