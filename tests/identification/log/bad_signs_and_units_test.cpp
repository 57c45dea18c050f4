// SPDX-License-Identifier: Apache-2.0
// Units and signs of a made log, turned by hand; what is refused must say what to write.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "identification/log/log.hpp"
#include "identification/reading/against_actuator.hpp"
#include "tests/identification/log/made_log.hpp"
#include "tests/identification/log/written_log.hpp"

namespace torquewright::identification {
namespace {

using test::MadeLog;
using test::read;
using test::ReadLog;

constexpr double kHalfTurn = std::numbers::pi;
constexpr double kDegree = kHalfTurn / 180.0;
constexpr double kSpeed_rad_s = 2 * kHalfTurn * 0.7;

const nlohmann::json kArmRig = test::rig_json({{"t", "time_s"},
                                               {"q", "output_position_rad"},
                                               {"w", "output_velocity_rad_s"},
                                               {"i", "motor_current_A"},
                                               {"tau", "output_torque_Nm"}});

/// A swing with its speed, and a current along with it that makes 2 Nm/A; factors on each.
struct Factors {
  double q = 1.0, w = 1.0, i = 1.0, tau = 1.0, late_s = 0.0;
};
MadeLog swing(const Factors& factor) {
  return MadeLog(9.0, 200.0)
      .add("q", [=](double t) { return factor.q * 0.8 * std::sin(kSpeed_rad_s * t); })
      .add("w",
           [=](double t) {
             return factor.w * 0.8 * kSpeed_rad_s * std::cos(kSpeed_rad_s * (t - factor.late_s));
           })
      .add("i", [=](double t) { return factor.i * 3.0 * std::cos(kSpeed_rad_s * t + 0.6); })
      .add("tau", [=](double t) { return factor.tau * 6.0 * std::cos(kSpeed_rad_s * t + 0.6); });
}

std::string refusal_of(const Factors& factor, const nlohmann::json& rig = kArmRig) {
  return read({{"a.csv", swing(factor).text()}}, rig).refusal;
}

TEST(BadLog, DegreesUnderARadNameAreRefused) {
  EXPECT_EQ(
      refusal_of({.q = 1.0 / kDegree}),
      "rig.json#/columns/q: d(output_position_rad)/dt is 57.3 times output_velocity_rad_s: the "
      "position looks like degrees; write {\"quantity\": \"output_position_rad\", \"scale\": "
      "0.0174533} for the column \"q\"");
  EXPECT_NE(refusal_of({.w = 1.0 / kDegree}).find("#/columns/w: "), std::string::npos);
  EXPECT_NE(refusal_of({.w = 30.0 / kHalfTurn}).find("it looks like rpm"), std::string::npos);
  EXPECT_EQ(refusal_of({}), "");
  EXPECT_EQ(refusal_of({.q = 3.2}), "");  // a gain error of the velocity is an effect to be found
}

TEST(BadLog, DegreesThatStartAnewAreRefused) {
  const nlohmann::json rig = test::rig_json({{"t", "time_s"}, {"q", "output_position_rad"}});
  for (const double start : {0.0, -180.0}) {
    MadeLog log(9.0, 200.0);
    log.add("q", [=](double t) { return start + std::fmod(100.0 * t, 360.0); });
    EXPECT_NE(read({{"a.csv", log.text()}}, rig).refusal.find("jumps by 360 in run \"a\""),
              std::string::npos);
  }
}

TEST(BadLog, ManyTurnsOfAPendulumMayBeDegrees) {
  nlohmann::json rig = test::rig_json({{"t", "time_s"}, {"q", "output_position_rad"}});
  rig["load"] = {{"type", "pendulum"}, {"mass_kg", 1}, {"length_m", 1}, {"inertia_kg_m2", 0}};
  const auto said = [&](double amplitude) {
    MadeLog log(9.0, 200.0);
    log.add("q", [=](double t) { return amplitude * std::sin(3 * t); });
    return read({{"a.csv", log.text()}}, rig).finding("turns of a load that hangs");
  };
  EXPECT_EQ(said(9.5).weight, Weight::kWarning);  // 19 rad; three turns are 18.85
  EXPECT_EQ(said(9.3).sentence, "");
}

TEST(BadLog, PositionAndVelocityOfOppositeSignsAreRefused) {
  EXPECT_NE(refusal_of({.w = -1.0})
                .find("output_velocity_rad_s and d(output_position_rad)/dt have "
                      "opposite signs (correlation -1.00)"),
            std::string::npos);
  EXPECT_NE(refusal_of({.q = -1.0}).find("\"scale\": -1}"), std::string::npos);
  // 0.3 s late the swing stands at cos(1.32) = 0.25 of itself, 0.5 s late at -0.59, and 0.7 s late
  // at -1.00.
  EXPECT_EQ(refusal_of({.late_s = 0.3}), "");
  EXPECT_EQ(refusal_of({.late_s = 0.5}), "");
  EXPECT_EQ(read({{"a.csv", swing({.late_s = 0.5}).text()}}, kArmRig)
                .finding("a wrong sign is suspected")
                .weight,
            Weight::kWarning);
  EXPECT_NE(refusal_of({.late_s = 0.7}), "");
}

/// 20:1, 48 V, 20 A, a torque constant of 0.1 Nm/A: no load at 48/0.1/20 = 24 rad/s.
actuator::Actuator nominal() {
  actuator::Actuator actuator;
  actuator.motor.torque_constant_Nm_A = 0.1;
  actuator.drive.bus_voltage_V = 48.0;
  actuator.drive.peak_current_A = 20.0;
  actuator.transmission.ratio = 20.0;
  return actuator;
}

ReadLog checked(const Factors& factor, const nlohmann::json& rig = kArmRig,
                const actuator::Actuator& actuator = nominal()) {
  ReadLog result = read({{"a.csv", swing(factor).text()}}, rig);
  if (!result.refusal.empty()) return result;
  result.refusal = test::refusal([&] { check_against(result.log, test::rig_of(rig), {actuator}); });
  return result;
}

TEST(BadLog, NothingIsSaidOfAGoodOneAgainstItsActuator) {
  const ReadLog result = checked({});
  EXPECT_EQ(result.refusal, "");
  EXPECT_EQ(result.log.findings.size(), 1u);  // of the hold-out
}

TEST(BadLog, CurrentInMilliamperesIsRefused) {
  EXPECT_EQ(
      checked({.i = 1000.0}).refusal,
      "rig.json#/columns/i: motor_current_A reaches 3000 A, the drive's peak is 20 A: it looks "
      "like mA; write {\"quantity\": \"motor_current_A\", \"scale\": 0.001} for the column \"i\"");
  EXPECT_EQ(checked({.i = 132.0}).refusal, "");  // 396 A, not yet 400
  EXPECT_NE(checked({.i = 135.0}).refusal, "");
  EXPECT_EQ(checked({.i = 10.2}).finding("beyond the 20 A").weight, Weight::kWarning);  // 30.6 A
  EXPECT_EQ(checked({.i = 9.8}).finding("beyond the 20 A").sentence, "");
}

// Both position and velocity in degrees agree with each other; the actuator does not turn so fast.
TEST(BadLog, DegreesOfBothAreRefusedAgainstTheActuator) {
  const Factors degrees{.q = 1.0 / kDegree, .w = 1.0 / kDegree};
  const ReadLog result = checked(degrees);
  EXPECT_NE(result.refusal.find("times the actuator's no-load speed: it looks like degrees; write"),
            std::string::npos);
  nlohmann::json rig = kArmRig;
  rig["uncertain"] = {"/motor/torque_constant_Nm_A"};
  EXPECT_EQ(checked(degrees, rig).refusal, "");
  EXPECT_EQ(checked(degrees, rig).finding("it looks like degrees").weight, Weight::kWarning);
}

// A speed without a position that could show its unit: rpm are 9.55 times rad/s. Oracle: the
// no-load speed of 24 rad/s, and what the swing's speed is multiplied by.
TEST(BadLog, SpeedFarBeyondNoLoadSuggestsRpm) {
  const nlohmann::json rig =
      test::rig_json({{"t", "time_s"}, {"w", "output_velocity_rad_s"}, {"i", "motor_current_A"}});
  const auto log_of = [&](double times_no_load) {
    const double w = times_no_load * 24.0 / (0.8 * kSpeed_rad_s);
    const MadeLog log =
        MadeLog(9.0, 200.0)
            .add("w", [=](double t) { return w * 0.8 * kSpeed_rad_s * std::cos(kSpeed_rad_s * t); })
            .add("i", [=](double t) { return 3.0 * std::cos(kSpeed_rad_s * t); });
    ReadLog result = read({{"a.csv", log.text()}}, rig);
    result.refusal =
        test::refusal([&] { check_against(result.log, test::rig_of(rig), {nominal()}); });
    return result;
  };
  const ReadLog suspect = log_of(2.7);
  EXPECT_EQ(suspect.refusal, "");
  EXPECT_EQ(suspect
                .finding("2.7 times the actuator's no-load speed: it looks like rpm; write "
                         "{\"quantity\": \"output_velocity_rad_s\", \"unit\": \"rpm\"} for the "
                         "column \"w\"")
                .weight,
            Weight::kWarning);
  EXPECT_EQ(log_of(1.9).finding("times the actuator's no-load speed").sentence, "");
  EXPECT_NE(log_of(5.2).refusal.find("it looks like rpm"), std::string::npos);
  EXPECT_NE(log_of(25.0).refusal.find("it looks like deg/s"), std::string::npos);
}

TEST(BadLog, TorqueOfTheWrongSignIsSuspectedAndSaid) {
  const ReadLog result = checked({.tau = -1.0});
  EXPECT_EQ(result.refusal, "");
  EXPECT_EQ(result.finding("output_torque_Nm goes against motor_current_A").weight,
            Weight::kWarning);
  // The log cannot tell which of the two it is.
  const std::string either = checked({.i = -1.0}).finding("goes against").sentence;
  EXPECT_NE(either.find("{\"quantity\": \"output_torque_Nm\", \"scale\": -1}"), std::string::npos)
      << either;
  EXPECT_NE(either.find("the sign of motor_current_A is wrong: write {\"quantity\": "
                        "\"motor_current_A\", \"scale\": -1}"),
            std::string::npos)
      << either;
  actuator::Actuator reversing = nominal();
  reversing.transmission.ratio = -20.0;
  EXPECT_EQ(checked({.tau = -1.0}, kArmRig, reversing).finding("goes against").sentence, "");
  EXPECT_NE(checked({}, kArmRig, reversing).finding("goes against").sentence, "");
}

TEST(BadLog, DriveThatBrakesAllInAllIsSuspected) {
  nlohmann::json rig = kArmRig;
  rig["load"] = {{"type", "free"}, {"inertia_kg_m2", 0.1}};
  EXPECT_EQ(checked({}, rig).finding("works against the motion").sentence, "");
  const ReadLog turned = checked({.i = -1.0, .tau = -1.0}, rig);
  EXPECT_NE(turned.finding("motor_current_A works against the motion").sentence, "");
  EXPECT_EQ(checked({.i = -1.0, .tau = -1.0}).finding("works against").sentence,
            "");  // dynamometer
}

TEST(BadLog, MotorThatTurnsAgainstItsGearboxIsRefused) {
  const nlohmann::json rig =
      test::rig_json({{"t", "time_s"}, {"q", "output_position_rad"}, {"m", "motor_position_rad"}});
  const auto refusal = [&](double ratio) {
    MadeLog log(9.0, 200.0);
    log.add("q", [](double t) { return std::sin(3 * t); }).add("m", [=](double t) {
      return ratio * std::sin(3 * t);
    });
    ReadLog result = read({{"a.csv", log.text()}}, rig);
    return test::refusal([&] { check_against(result.log, test::rig_of(rig), {nominal()}); });
  };
  EXPECT_EQ(refusal(20.0), "");
  EXPECT_NE(refusal(-20.0).find("motor_position_rad moves against output_position_rad"),
            std::string::npos);
}

}  // namespace
}  // namespace torquewright::identification
