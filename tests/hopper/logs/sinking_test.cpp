// SPDX-License-Identifier: Apache-2.0
// How deep feet sink into soft ground. Oracle: MuJoCo 2.2.2 with its default ground, drops of a
// ball and of a robot from several heights.
#include <gtest/gtest.h>

#include <algorithm>
#include <optional>

#include "hopper/check/hopper_check.hpp"
#include "robot/mjcf/mjcf_writer.hpp"
#include "tests/dynamics/mujoco_engine.hpp"
#include "tests/hopper/logs/hop_log.hpp"

namespace torquewright::test {
namespace {

using Eigen::Index;

constexpr double kRadius_m = 0.02;

hopper::Robot ball() {
  hopper::Robot robot;
  robot.name = "ball";
  robot.tree.base = dynamics::BaseKind::kSpatial;
  robot.tree.bodies.resize(1);
  robot.tree.bodies[0].name = "ball";
  robot.tree.bodies[0].inertia = {1.0, Eigen::Vector3d::Zero(),
                                  1.6e-4 * Eigen::Matrix3d::Identity()};
  robot.contacts.push_back({"ball", {0, Eigen::Vector3d::Zero()}, 0.8, 0.0, kRadius_m});
  return robot;
}

hopper::Motion drop_of(const hopper::Robot& robot, double height_m, double step_s) {
  MujocoEngine mujoco(hopper::mjcf_of(robot, {.ground = true, .collisions = true}).text);
  mujoco.model().opt.timestep = step_s;
  mujoco.data().qpos[2] = height_m + kRadius_m;
  const auto samples = static_cast<Index>(0.8 / step_s);
  hopper::Motion motion;
  motion.file = "drop.csv";
  motion.positions.resize(7, samples);
  motion.velocities.resize(6, samples);
  motion.accelerations.setZero(6, samples);
  motion.acceleration_origin = hopper::Origin::kAbsent;
  motion.forces_N.setZero(3, samples);
  motion.touching.setZero(1, samples);
  motion.efforts.setZero(0, samples);
  for (Index i = 0; i < samples; ++i) {
    motion.times_s.push_back(step_s * static_cast<double>(i));
    for (Index row = 0; row < 7; ++row) motion.positions(row, i) = mujoco.data().qpos[row];
    for (Index row = 0; row < 6; ++row) motion.velocities(row, i) = mujoco.data().qvel[row];
    mj_step(&mujoco.model(), &mujoco.data());
  }
  return motion;
}

std::optional<hopper::Finding> sunken(const hopper::HopperReport& report) {
  for (const hopper::Finding& finding : report.check.findings) {
    if (finding.rule == "contact-below-ground") return finding;
  }
  return std::nullopt;
}

TEST(Sinking, OfADroppedBallIsWhatSoftGroundLetsIt) {
  const hopper::Robot robot = ball();
  for (const double height_m : {0.02, 0.05, 0.2, 0.5, 1.0}) {
    for (const double step_s : {2.5e-4, 1e-3, 2e-3}) {
      SCOPED_TRACE(testing::Message() << height_m << " m, " << step_s << " s");
      hopper::Motion motion = drop_of(robot, height_m, step_s);
      hopper::CheckOptions options;
      options.residual_share = 1e3;  // its landing is not the question
      const auto finding = sunken(hopper::check_motion(robot, motion, options));
      ASSERT_TRUE(finding);
      EXPECT_EQ(finding->severity, actuator::Severity::kWarning) << finding->sentence;
      // No more than needed, but for what a coarse step and the load take and give.
      EXPECT_GT(*finding->value / *finding->limit, step_s < 1.5e-3 ? 0.8 : 0.6)
          << finding->sentence;
      // Ground that is stated to be half as soft does not.
      options.contact.time_constant_s = 0.01;
      motion = drop_of(robot, height_m, step_s);
      const auto stiff = sunken(hopper::check_motion(robot, motion, options));
      ASSERT_TRUE(stiff);
      EXPECT_EQ(stiff->severity, actuator::Severity::kViolation) << stiff->sentence;
    }
  }
}

// Feet of robots are light and pressed: their load sinks them too.
TEST(Sinking, OfHoppingRobotsIsNoViolation) {
  for (const std::string& name : public_hoppers()) {
    const auto hopper = read_public_hopper(name);
    if (!hopper) GTEST_SKIP() << "needs the public robots, ../shared/data";
    const SimulatedHop hop = simulate_hop(*hopper);
    hopper::Motion log = log_of(*hopper, hop, {1000, true, true, true, false, 0.0});
    const auto report = hopper::check_motion(hopper->robot, log, {});
    const auto finding = sunken(report);
    if (!finding) continue;
    EXPECT_EQ(finding->severity, actuator::Severity::kWarning) << name << ": " << finding->sentence;
    RecordProperty(name, finding->sentence);
  }
}

}  // namespace
}  // namespace torquewright::test
