// SPDX-License-Identifier: Apache-2.0
// Published motions through `hopper check`. Oracles: Rabbit's stored accelerations, torques and
// forces, made by its authors' engine; for Cassie and the mini cheetah the figures that a check of
// the same files by hand gave (they are in the data's own notes).
#include "hopper/check/hopper_check.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "hopper/motion/motion_reader.hpp"
#include "io/files/csv.hpp"
#include "robot/model/robot_spec.hpp"

namespace torquewright::hopper {
namespace {

namespace fs = std::filesystem;
using Eigen::Index;

const fs::path kSource = TORQUEWRIGHT_SOURCE_DIR;

fs::path motions() {
  const char* variable = std::getenv("TORQUEWRIGHT_DATA");
  const fs::path data = variable != nullptr ? fs::path(variable) : kSource / "../shared/data";
  return data / "trajectories";
}

class PublishedMotion : public testing::Test {
 protected:
  void SetUp() override {
    if (!fs::is_directory(motions())) {
      GTEST_SKIP() << "needs the published motions, ../shared/data";
    }
  }

  static HopperReport check(const char* robot, const fs::path& file, const char* columns,
                            double until_s = 1e9) {
    const ReadRobot read = read_robot(kSource / "specs/robot" / robot);
    MotionFile source;
    source.file = motions() / file;
    source.documents = {
        io::read_document(kSource / "specs/trajectory" / columns, "trajectory_columns")};
    source.window.until_s = until_s;
    Motion motion = read_motion(read.robot, source);
    return check_motion(read.robot, motion, {});
  }

  static const actuator::DriveReport& drive(const HopperReport& report, const std::string& name) {
    for (const actuator::DriveReport& drive : report.check.drives) {
      if (drive.name == name) return drive;
    }
    throw std::runtime_error(name);
  }
};

TEST_F(PublishedMotion, CassiesJumpLeavesTheRegionOfBothKnees) {
  const HopperReport report = check("cassie.json", "cassie/jump.csv", "cassie_columns.json");
  EXPECT_EQ(report.check.verdict, actuator::Verdict::kFail);
  const auto& left = drive(report, "knee_left").interpretation;
  EXPECT_NEAR(left.worst.time_s, 0.558, 5e-4);
  EXPECT_NEAR(left.worst.torque_Nm, 73, 0.5);
  EXPECT_NEAR(left.worst.speed_rad_s, 8.80, 5e-3);
  const auto& right = drive(report, "knee_right").interpretation;
  EXPECT_NEAR(right.worst.torque_Nm, 61.3, 0.05);
  EXPECT_NEAR(*right.worst.limit_Nm, 4.5, 0.05);
  for (const auto& one : report.check.drives) {
    const bool is_knee = one.name.starts_with("knee");
    EXPECT_EQ(one.verdict == actuator::Verdict::kFail, is_knee) << one.name;
  }
}

TEST_F(PublishedMotion, TheMiniCheetahsFrontJumpClipsItsRearHip) {
  const char* file = "mini_cheetah/front_jump_pitchup.csv";
  const char* columns = "mini_cheetah_columns.json";
  const HopperReport whole = check("mini_cheetah.json", file, columns);
  const HopperReport part = check("mini_cheetah.json", file, columns, 0.6);
  const auto share = [](const actuator::DriveReport& drive) {
    return 100.0 * static_cast<double>(drive.interpretation.clipped_samples) /
           static_cast<double>(drive.samples);
  };
  EXPECT_NEAR(share(drive(whole, "rhip")), 10.2, 0.05);
  EXPECT_NEAR(share(drive(part, "rhip")), 16.1, 0.05);
  EXPECT_NEAR(drive(part, "rhip").interpretation.worst.excess_Nm, 1.271, 5e-4);
  const HopperReport flip = check("mini_cheetah.json", "mini_cheetah/mc_flip.csv", columns, 0.6);
  for (const auto& one : flip.check.drives) {
    EXPECT_EQ(one.verdict, actuator::Verdict::kPass) << one.name;
  }
}

/// A table of the walking, a row per knot.
Eigen::MatrixXd table(const std::string& name) {
  io::CsvReader reader(motions() / "rabbit" / ("rabbit_walking." + name + ".csv"));
  std::vector<std::vector<double>> rows;
  while (reader.next()) {
    rows.emplace_back();
    for (std::size_t i = 0; i < reader.header().size(); ++i)
      rows.back().push_back(reader.number(i));
  }
  Eigen::MatrixXd values(rows.size(), rows.front().size());
  for (Index i = 0; i < values.rows(); ++i) {
    for (Index j = 0; j < values.cols(); ++j) {
      values(i, j) = rows[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
    }
  }
  return values;
}

/// One mode of the walking, with accelerations and torques, with or without the foot's forces.
Motion walking(int mode, bool with_forces) {
  const std::string number = std::to_string(mode);
  const Eigen::MatrixXd states = table("state_traj" + number);
  const Eigen::MatrixXd rates = table("state_derivative_traj" + number);
  const Eigen::MatrixXd forces = table("force_vars" + number);
  const Eigen::MatrixXd inputs = table("input_traj");
  Motion motion;
  for (Index i = 0; i < states.rows(); ++i) motion.times_s.push_back(states(i, 0));
  motion.positions = states.middleCols(1, 7).transpose();
  motion.velocities = states.rightCols(7).transpose();
  motion.accelerations = rates.rightCols(7).transpose();
  motion.efforts.setZero(4, states.rows());
  for (Index i = 0; i < states.rows(); ++i) {
    for (Index k = 0; k < inputs.rows(); ++k) {
      if (inputs(k, 0) == states(i, 0)) motion.efforts.col(i) = inputs.row(k).tail(4).transpose();
    }
  }
  motion.has_effort.assign(4, true);
  motion.forces_N.setZero(6, states.rows());
  motion.has_forces = with_forces;
  const Index foot = mode == 1 ? 3 : 0;
  motion.forces_N.row(foot) = forces.col(1).transpose();
  motion.forces_N.row(foot + 2) = forces.col(2).transpose();
  return motion;
}

TEST_F(PublishedMotion, RabbitsWalkingLeavesNothingUnexplained) {
  const Robot robot = read_robot(kSource / "specs/robot/rabbit.json").robot;
  double worst_force_N = 0.0;
  double worst_difference_N = 0.0;
  for (int mode = 0; mode < 3; ++mode) {
    Motion given = walking(mode, true);
    const HopperReport told = check_motion(robot, given, {});
    worst_force_N = std::max(worst_force_N, told.demand.residual.cwiseAbs().maxCoeff());
    // Found again from the motion and its torques: one foot stands, so they are unique.
    Motion asked = walking(mode, false);
    const HopperReport found = check_motion(robot, asked, {});
    ASSERT_TRUE(found.demand.jolts.empty());
    for (Index i = 0; i < asked.samples(); ++i) {
      worst_difference_N = std::max(worst_difference_N,
                                    (found.demand.forces_N.col(i) - given.forces_N.col(i)).norm());
    }
  }
  std::printf("left unexplained: %.2g; forces found again to %.2g N\n", worst_force_N,
              worst_difference_N);
  EXPECT_LE(worst_force_N, 1e-9);
  EXPECT_LE(worst_difference_N, 1e-5);  // of some 300 N; kTieBreaker is 1e-8
}

}  // namespace
}  // namespace torquewright::hopper
