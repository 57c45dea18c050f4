// SPDX-License-Identifier: Apache-2.0
// A replay that ended before its first row. Oracle: what such a page may hold by its own header.
#include "src/report/motion/replay_html.hpp"

#include <gtest/gtest.h>

#include "robot/model/robot_spec.hpp"

namespace torquewright::report {
namespace {

TEST(ReplayHtml, RunWithoutARowHasAPageWithoutPicturesAndScript) {
  const hopper::ReadRobot read =
      hopper::read_robot(TORQUEWRIGHT_SOURCE_DIR "/specs/robot/hopper.json");
  const hopper::Robot& robot = read.robot;
  hopper::Motion motion;
  motion.file = "a<b>.csv";
  motion.times_s = {0.0, 1.0};
  motion.positions.setZero(robot.tree.position_size(), 2);
  motion.positions.row(3).setOnes();
  motion.velocities.setZero(robot.tree.velocity_size(), 2);
  motion.accelerations.setZero(robot.tree.velocity_size(), 2);
  hopper::ContactSchedule contacts;
  contacts.touches.setConstant(static_cast<Eigen::Index>(robot.contacts.size()), 2, true);
  const hopper::Reference reference(robot, motion, contacts, Eigen::MatrixXd::Zero(3, 2));
  hopper::Record record;
  record.end = hopper::RunEnd::kAsked;
  hopper::ReplayReport report;
  report.result.outcome.reason = "stopped & <gone>";
  const std::string page = replay_html({robot, motion, reference, record, report});
  EXPECT_NE(page.find("<span class=\"badge unfinished\">unfinished</span>"), std::string::npos);
  EXPECT_NE(page.find("stopped &amp; &lt;gone&gt;"), std::string::npos);
  EXPECT_NE(page.find("a&lt;b&gt;.csv"), std::string::npos);
  EXPECT_EQ(page.find("<gone>"), std::string::npos);
  EXPECT_EQ(page.find("<script"), std::string::npos);
  EXPECT_EQ(page.find("<svg"), std::string::npos);
  EXPECT_TRUE(page.ends_with("</html>\n"));
}

}  // namespace
}  // namespace torquewright::report
