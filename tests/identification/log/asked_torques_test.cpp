// SPDX-License-Identifier: Apache-2.0
// What was asked of a drive, where the log holds a part of it or no sign. Oracle: closed forms.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "identification/reading/given_signs.hpp"
#include "tests/identification/log/made_log.hpp"
#include "tests/identification/log/written_log.hpp"

namespace torquewright::identification {
namespace {

using nlohmann::json;
using test::MadeLog;

constexpr double kTurn = 2.0 * std::numbers::pi;
constexpr double kStiffness_Nm_rad = 40.0, kDamping_Nm_s_rad = 0.8, kLimit_Nm = 6.0;

double position_rad(double time_s) { return 0.3 * std::sin(kTurn * 0.7 * time_s); }
double speed_rad_s(double time_s) { return 0.3 * kTurn * 0.7 * std::cos(kTurn * 0.7 * time_s); }
double command_rad(double time_s) { return 0.34 * std::sin(kTurn * 0.7 * time_s + 0.1); }
double feedforward_Nm(double time_s) { return 5.0 * std::cos(kTurn * 1.1 * time_s); }

MadeLog asked_log() {
  return MadeLog(10.0, 500.0)
      .add("q", position_rad)
      .add("goal", command_rad)
      .add("tau_ff", feedforward_Nm);
}

json asked_rig() {
  json rig = test::rig_json({{"t", "time_s"},
                             {"q", "output_position_rad"},
                             {"goal", "commanded_position_rad"},
                             {"tau_ff", "feedforward_torque_Nm"}});
  rig["load"] = {{"type", "free"}, {"inertia_kg_m2", 0.1}};
  rig["controller"] = {{"type", "pd"},
                       {"stiffness_Nm_rad", kStiffness_Nm_rad},
                       {"damping_Nm_s_rad", kDamping_Nm_s_rad},
                       {"torque_limit_Nm", kLimit_Nm}};
  return rig;
}

TEST(FeedforwardTorque, IsAddedBeforeTheLawIsCut) {
  const test::ReadLog read = test::read({{"log.csv", asked_log().text()}}, asked_rig());
  ASSERT_EQ(read.refusal, "");
  int cut = 0, rows = 0;
  for (const auto& run : read.log.runs) {
    const Channels& channels = run.joints[0];
    EXPECT_FALSE(channels.has(Quantity::kFeedforwardTorque));
    for (std::size_t i = 1; i + 1 < run.time_s.size(); ++i, ++rows) {
      const double time_s = run.time_s[i];
      const double whole_Nm = kStiffness_Nm_rad * (command_rad(time_s) - position_rad(time_s)) -
                              kDamping_Nm_s_rad * speed_rad_s(time_s) + feedforward_Nm(time_s);
      if (std::abs(whole_Nm) > kLimit_Nm) ++cut;
      // The speed is a difference over 4 ms: off by less than speed (w dt)^2/6, 1e-4 rad/s.
      EXPECT_NEAR(channels[Quantity::kCommandedTorque][i],
                  std::clamp(whole_Nm, -kLimit_Nm, kLimit_Nm), 1e-3);
    }
  }
  EXPECT_GT(cut, rows / 20);
  EXPECT_LT(cut, rows);
}

TEST(FeedforwardTorque, NeedsALawWithAStatedStiffness) {
  json rig = asked_rig();
  rig.erase("controller");
  EXPECT_NE(test::read({{"log.csv", asked_log().text()}}, rig)
                .refusal.find("no \"controller\" states its law"),
            std::string::npos);
  rig = asked_rig();
  rig["controller"] = {{"type", "position_servo"}, {"stiffness_Nm_rad", 40}};
  EXPECT_NE(test::read({{"log.csv", asked_log().text()}}, rig).refusal.find("to be found"),
            std::string::npos);
}

/// A current that follows what is asked for by 6 ms, logged as a magnitude in steps of 0.05 A.
constexpr double kStep_A = 0.05;
double current_A(double time_s) { return 3.0 * std::sin(kTurn * 1.3 * (time_s - 0.006)) + 0.4; }
double asked_A(double time_s) { return 3.0 * std::sin(kTurn * 1.3 * time_s) + 0.4; }

TEST(GivenSigns, AreThoseOfACurrentThatFollowsLate) {
  std::vector<double> time_s, magnitude, asked;
  for (int i = 0; i < 5000; ++i) {
    time_s.push_back(1e-3 * i);
    magnitude.push_back(kStep_A * std::round(std::abs(current_A(time_s.back())) / kStep_A));
    asked.push_back(asked_A(time_s.back()));
  }
  const std::vector<double> values = with_signs(time_s, magnitude, asked);
  for (std::size_t i = 0; i < values.size(); ++i) {
    EXPECT_NEAR(values[i], current_A(time_s[i]), 2.0 * kStep_A) << time_s[i];
  }
}

TEST(GivenSigns, BeginAsWhatIsAskedForBegins) {
  EXPECT_EQ(with_signs({0, 1, 2, 3}, {0, 1, 2, 1}, {0, -1, -2, -1}),
            (std::vector<double>{-0.0, -1, -2, -1}));
  EXPECT_EQ(with_signs({0, 1}, {2, 3}, {0, 0}), (std::vector<double>{2, 3}));
}

MadeLog magnitude_log() {
  return MadeLog(10.0, 500.0)
      .add("q", position_rad)
      .add("tau", asked_A)
      .add("i", [](double time_s) { return std::abs(current_A(time_s)); });
}

json magnitude_rig() {
  json rig = test::rig_json({{"t", "time_s"},
                             {"q", "output_position_rad"},
                             {"tau", "commanded_torque_Nm"},
                             {"i", "motor_current_A"}});
  rig["columns"]["i"] = {{"quantity", "motor_current_A"}, {"sign", "none"}};
  rig["load"] = {{"type", "free"}, {"inertia_kg_m2", 0.1}};
  return rig;
}

TEST(GivenSigns, ComeFromTheCommandedTorqueOfTheLog) {
  const test::ReadLog read = test::read({{"log.csv", magnitude_log().text()}}, magnitude_rig());
  ASSERT_EQ(read.refusal, "");
  EXPECT_NE(read.finding("was logged without a sign").sentence, "");
  for (const auto& run : read.log.runs) {
    for (std::size_t i = 0; i < run.time_s.size(); ++i) {
      // A sample beside the turn may be the other sign's: as much as it changes within 2 ms.
      EXPECT_NEAR(run.joints[0][Quantity::kMotorCurrent][i], current_A(run.time_s[i]),
                  2.0 * 3.0 * kTurn * 1.3 * 2e-3);
    }
  }
}

TEST(GivenSigns, AreRefusedWithoutATorqueOrBelowZero) {
  json rig = magnitude_rig();
  rig["columns"].erase("tau");
  rig["ignore"] = json::array({"tau"});
  EXPECT_NE(test::read({{"log.csv", magnitude_log().text()}}, rig)
                .refusal.find("takes that of the torque that was asked for"),
            std::string::npos);
  MadeLog log = MadeLog(10.0, 500.0).add("q", position_rad).add("tau", asked_A).add("i", current_A);
  EXPECT_NE(test::read({{"log.csv", log.text()}}, magnitude_rig())
                .refusal.find("is said to have no sign"),
            std::string::npos);
  rig = magnitude_rig();
  rig["columns"]["q"] = {{"quantity", "output_position_rad"}, {"sign", "none"}};
  EXPECT_NE(test::read({{"log.csv", magnitude_log().text()}}, rig).refusal.find("/columns/q/sign"),
            std::string::npos);
}

}  // namespace
}  // namespace torquewright::identification
