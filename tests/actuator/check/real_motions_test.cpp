// SPDX-License-Identifier: Apache-2.0
// Published motions of real robots against their actuators. Oracle: the figures in the README of
// the data, found there by an independent program with the laws of the robots' own simulators.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <list>

#include "actuator/check/check.hpp"
#include "actuator/motor/actuator_spec.hpp"
#include "actuator/trajectory/columns_spec.hpp"

namespace torquewright::actuator {
namespace {

namespace fs = std::filesystem;

const fs::path kSource = TORQUEWRIGHT_SOURCE_DIR;

/// The folder of the published motions, or nothing where it is absent.
fs::path motions() {
  const char* variable = std::getenv("TORQUEWRIGHT_DATA");
  const fs::path data = variable != nullptr ? fs::path(variable) : kSource / "../shared/data";
  return fs::is_directory(data / "trajectories") ? data / "trajectories" : fs::path();
}

/// The two ways in which the mini cheetah's back-EMF is stated.
struct BackEmf {
  const char* name;
  double constant_V_s_rad;
};
const BackEmf kTwoTimesFlux{"two_times_flux", 0.1};
const BackEmf kRootThreeTimesFlux{"root_three_times_flux", 0.05 * std::sqrt(3.0)};
void PrintTo(const BackEmf& emf, std::ostream* out) { *out << emf.name; }

/// A check with the example documents; actuators are those of the request.
struct Case {
  std::list<Actuator> actuators;
  CheckRequest request;

  void add_joint(const std::string& name, const std::string& document, double back_emf_V_s_rad) {
    actuators.push_back(read_actuator(kSource / "specs/actuator" / document).actuator);
    if (back_emf_V_s_rad > 0.0) actuators.back().motor.back_emf_constant_V_s_rad = back_emf_V_s_rad;
    request.drives.push_back({name, &actuators.back(), {}});
  }
  void add_columns(const std::string& document) {
    request.columns = read_columns(
        io::read_document(kSource / "specs/trajectory" / document, "trajectory_columns"));
  }
};

Case mini_cheetah(const char* motion, const BackEmf& back_emf) {
  Case result;
  for (const char* leg : {"f", "r"}) {
    result.add_joint(leg + std::string("hip"), "mini_cheetah_hip.json", back_emf.constant_V_s_rad);
    result.add_joint(leg + std::string("knee"), "mini_cheetah_knee.json",
                     back_emf.constant_V_s_rad);
  }
  result.add_columns("mini_cheetah_columns.json");
  result.request.trajectory = motions() / "mini_cheetah" / motion;
  return result;
}

class MiniCheetah : public testing::TestWithParam<BackEmf> {
  void SetUp() override {
    if (motions().empty()) GTEST_SKIP() << "the published motions (../shared/data) are not here";
  }
};

TEST_P(MiniCheetah, BackFlipPasses) {
  for (const double until_s : {0.6, 10.0}) {
    Case flip = mini_cheetah("mc_flip.csv", GetParam());
    flip.request.window.until_s = until_s;
    const CheckReport report = check(flip.request);
    EXPECT_EQ(report.verdict, Verdict::kPass);
    for (const DriveReport& drive : report.drives)
      EXPECT_EQ(drive.interpretation.clipped_samples, 0u);
  }
}

TEST_P(MiniCheetah, FrontJumpClipsTheRearHip) {
  Case jump = mini_cheetah("front_jump_pitchup.csv", GetParam());
  const CheckReport whole = check(jump.request);
  EXPECT_EQ(whole.verdict, Verdict::kFail);
  const DriveReport& hip = whole.drives[2];
  ASSERT_EQ(hip.name, "rhip");
  EXPECT_EQ(hip.interpretation.clipped_samples, 97u);  // 10.2 % of 950
  EXPECT_EQ(hip.samples, 950u);
  EXPECT_NEAR(hip.interpretation.worst.excess_Nm, 1.271, 5e-4);
  EXPECT_NEAR(hip.interpretation.worst.time_s, 0.504, 1e-9);
  EXPECT_EQ(hip.interpretation.worst.limiter, Limiter::kCurrent);
  for (const std::size_t other : {0u, 1u, 3u}) {
    EXPECT_EQ(whole.drives[other].interpretation.clipped_samples, 0u);
  }
  // The rear knee keeps 0.095 Nm as the file stands; the rotor's torque on top would clip it.
  EXPECT_EQ(whole.drives[3].verdict, Verdict::kUndecided);
  EXPECT_NEAR(whole.drives[3].interpretation.margin_Nm, 0.095, 5e-4);

  jump.request.window.until_s = 0.6;
  const CheckReport start = check(jump.request);
  EXPECT_EQ(start.drives[2].interpretation.clipped_samples, 97u);  // 16.1 % of 601
  EXPECT_EQ(start.drives[2].samples, 601u);
}

INSTANTIATE_TEST_SUITE_P(Conventions, MiniCheetah,
                         testing::Values(kTwoTimesFlux, kRootThreeTimesFlux),
                         [](const auto& chosen) { return chosen.param.name; });

TEST(Cassie, JumpIsInsideEveryTorqueBoxAndLeavesTheRegionInBothKnees) {
  if (motions().empty()) GTEST_SKIP() << "the published motions (../shared/data) are not here";
  Case jump;
  struct Joint {
    const char* name;
    const char* document;
    double effort_Nm;
  };
  const Joint joints[] = {{"hip_roll", "cassie_hip_roll_yaw.json", 112.5},
                          {"hip_yaw", "cassie_hip_roll_yaw.json", 112.5},
                          {"hip_pitch", "cassie_knee.json", 195.2},
                          {"knee", "cassie_knee.json", 195.2},
                          {"toe", "cassie_toe.json", 45.0}};
  for (const char* side : {"_left", "_right"}) {
    for (const Joint& joint : joints)
      jump.add_joint(joint.name + std::string(side), joint.document, 0.0);
  }
  jump.add_columns("cassie_columns.json");
  jump.request.trajectory = motions() / "cassie" / "jump.csv";
  const CheckReport report = check(jump.request);
  EXPECT_EQ(report.verdict, Verdict::kFail);
  ASSERT_EQ(report.drives.size(), 10u);
  for (std::size_t i = 0; i < 10; ++i) {
    const DriveReport& drive = report.drives[i];
    EXPECT_EQ(drive.samples, 22u);
    EXPECT_LE(drive.interpretation.peak_torque_Nm, joints[i % 5].effort_Nm) << drive.name;
    const bool is_knee = i % 5 == 3;
    EXPECT_EQ(drive.verdict, is_knee ? Verdict::kFail : Verdict::kPass) << drive.name;
    if (!is_knee) continue;
    EXPECT_EQ(drive.interpretation.clipped_samples, 1u);
    EXPECT_NEAR(drive.interpretation.worst.time_s, 0.558, 5e-4);
    EXPECT_EQ(drive.interpretation.worst.limiter, Limiter::kVoltage);
  }
  const DriveReport& left = report.drives[3];
  const DriveReport& right = report.drives[8];
  EXPECT_NEAR(left.interpretation.worst.torque_Nm, 73.3, 0.05);
  EXPECT_NEAR(left.interpretation.worst.speed_rad_s, 8.80, 5e-3);
  EXPECT_NEAR(left.no_load_speed_rad_s, 136.136 / 16.0, 1e-9);  // printed as 8.509
  // Beyond no-load speed the region begins below zero: their law, continued.
  EXPECT_NEAR(*left.interpretation.worst.limit_Nm,
              2.0 * 195.2 * (1.0 - left.interpretation.worst.speed_rad_s / 8.5085), 1e-3);
  EXPECT_NEAR(right.interpretation.worst.torque_Nm, 61.3, 0.05);
  EXPECT_NEAR(right.interpretation.worst.speed_rad_s, 8.409, 5e-4);
  EXPECT_NEAR(*right.interpretation.worst.limit_Nm, 4.5, 0.06);
}

}  // namespace
}  // namespace torquewright::actuator
