// SPDX-License-Identifier: Apache-2.0
// A drive that is known by its curve. Oracle: the curve that the document states, in closed form
// (docs/derivations/envelopes.md), and Unitree's law written down again.
#include "actuator/motor/envelope.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>

#include "actuator/mor/mor_table.hpp"
#include "actuator/mor/need.hpp"
#include "actuator/motor/actuator_spec.hpp"
#include "tests/actuator/check/refusal.hpp"
#include "tests/io/scratch_folder.hpp"

namespace torquewright::actuator {
namespace {

using nlohmann::json;

constexpr double kRoundOff_Nm = 1e-9;

json document_of(const char* envelope) {
  return {
      {"kind", "actuator"}, {"version", 1}, {"name", "curve"}, {"envelope", json::parse(envelope)}};
}

Actuator actuator_of(const json& document) {
  return read_actuator(io::check_document(document, "actuator", "f", "")).actuator;
}

Actuator actuator_of(const char* envelope) { return actuator_of(document_of(envelope)); }

/// Every fault, a line each.
std::string refusal(const json& document) {
  try {
    actuator_of(document);
  } catch (const io::SpecError& error) {
    return error.what();
  }
  return "accepted";
}

JointRange at(const Actuator& actuator, double speed_rad_s,
              const OperatingConditions& conditions = {}) {
  return range_at(actuator, conditions, speed_rad_s);
}

TEST(Envelope, OfTwoNumbersIsTheLineBetweenThem) {
  const Actuator drive = actuator_of(R"({"peak_torque_Nm": 33.5, "no_load_speed_rad_s": 21})");
  for (const double speed : {-20.0, -7.0, 0.0, 3.0, 20.9}) {
    const double most_Nm = 33.5 * (1.0 - std::abs(speed) / 21.0);
    EXPECT_NEAR(at(drive, speed).greatest.torque_Nm, most_Nm, kRoundOff_Nm) << speed;
    EXPECT_NEAR(at(drive, speed).least.torque_Nm, -most_Nm, kRoundOff_Nm) << speed;
  }
  EXPECT_TRUE(at(drive, 21.1).is_empty);
  EXPECT_EQ(at(drive, 21.1).why_empty, Limiter::kEnvelope);
}

// Y1 = 23.7 up to X1 = 13.5 with the motion, Y2 = 45.4 against it, both straight to 0 at X2 = 30.
TEST(Envelope, OfACornerIsUnitreesLaw) {
  const Actuator drive = actuator_of(
      R"({"peak_torque_Nm": 23.7, "corner_speed_rad_s": 13.5, "no_load_speed_rad_s": 30,
          "braking_torque_Nm": 45.4})");
  const auto law_Nm = [](double full_Nm, double speed) {
    const double w = std::abs(speed);
    return w < 13.5 ? full_Nm : std::max(0.0, full_Nm * (30.0 - w) / (30.0 - 13.5));
  };
  for (const double speed : {-29.0, -13.0, -1e-3, 1e-3, 5.0, 13.6, 29.9}) {
    const double with_Nm = law_Nm(23.7, speed), against_Nm = law_Nm(45.4, speed);
    EXPECT_NEAR(at(drive, speed).greatest.torque_Nm, speed > 0.0 ? with_Nm : against_Nm,
                kRoundOff_Nm);
    EXPECT_NEAR(at(drive, speed).least.torque_Nm, speed > 0.0 ? -against_Nm : -with_Nm,
                kRoundOff_Nm);
  }
  // At rest it jumps: a row from either side.
  const Region region(drive, {});
  EXPECT_NEAR(region.at(0.0, 1.0).greatest.torque_Nm, 23.7, kRoundOff_Nm);
  EXPECT_NEAR(region.at(0.0, -1.0).greatest.torque_Nm, 45.4, kRoundOff_Nm);
}

TEST(Envelope, OfAMaximumSpeedHasFullTorqueUpToIt) {
  const Actuator drive = actuator_of(R"({"peak_torque_Nm": 10, "maximum_speed_rad_s": 8})");
  EXPECT_NEAR(at(drive, 8.0).greatest.torque_Nm, 10.0, kRoundOff_Nm);
  EXPECT_TRUE(at(drive, 8.01).is_empty);
  // A simulator that goes beyond finds the table's end, where nothing drives.
  const MorTable table = mor_table(Region(drive, {}));
  EXPECT_NEAR(table.rows.back().range.greatest.torque_Nm, 0.0, 1e-3);
}

TEST(Envelope, OfPointsHasTheQuadrantsThatTheyName) {
  const Actuator drive = actuator_of(
      R"({"points": [{"speed_rad_s": 0, "torque_Nm": 10}, {"speed_rad_s": 5, "torque_Nm": 10},
                     {"speed_rad_s": 9, "torque_Nm": 0},
                     {"speed_rad_s": 0, "torque_Nm": -12}, {"speed_rad_s": 9, "torque_Nm": -16}]})");
  EXPECT_NEAR(at(drive, 7.0).greatest.torque_Nm, 5.0, kRoundOff_Nm);
  EXPECT_NEAR(at(drive, 7.0).least.torque_Nm, -12.0 - 4.0 * 7.0 / 9.0, kRoundOff_Nm);
  // The other way round the same.
  EXPECT_NEAR(at(drive, -7.0).least.torque_Nm, -5.0, kRoundOff_Nm);
  EXPECT_NEAR(at(drive, -7.0).greatest.torque_Nm, 12.0 + 4.0 * 7.0 / 9.0, kRoundOff_Nm);
}

/// Bounds in closed form: straight from `rest_Nm` to 0 at that speed.
double line_Nm(double rest_Nm, double end_rad_s, double speed_rad_s) {
  return rest_Nm * std::max(0.0, 1.0 - speed_rad_s / end_rad_s);
}

// A sheet of both ways of driving, 10 Nm to 5 rad/s one way and 8 Nm to 4 rad/s the other: each
// brakes as it drives.
TEST(Envelope, OfPointsThatDriveBothWaysBrakesBothWays) {
  const Actuator drive = actuator_of(
      R"({"points": [{"speed_rad_s": -4, "torque_Nm": 0}, {"speed_rad_s": 0, "torque_Nm": -8},
                     {"speed_rad_s": 0, "torque_Nm": 10}, {"speed_rad_s": 5, "torque_Nm": 0}]})");
  for (const double speed : {-3.0, -1.0, 1.0, 3.0}) {
    EXPECT_NEAR(at(drive, speed).greatest.torque_Nm, line_Nm(10.0, 5.0, std::abs(speed)),
                kRoundOff_Nm);
    EXPECT_NEAR(at(drive, speed).least.torque_Nm, -line_Nm(8.0, 4.0, std::abs(speed)),
                kRoundOff_Nm);
  }
  // As nothing is said of braking, simulators may brake with all there is, either way its own.
  ASSERT_EQ(drive.envelope->braking, Braking::kAsDriving);
  const EnvelopeCurve full = with_full_braking(*drive.envelope).peak;
  EXPECT_NEAR(bounds_at(full, 3.0)->greatest_Nm, 4.0, kRoundOff_Nm);
  EXPECT_NEAR(bounds_at(full, 3.0)->least_Nm, -8.0, kRoundOff_Nm);
  EXPECT_NEAR(bounds_at(full, -3.0)->greatest_Nm, 10.0, kRoundOff_Nm);
  EXPECT_NEAR(bounds_at(full, -3.0)->least_Nm, -2.0, kRoundOff_Nm);
}

// Speeds of one sign, driving 8 Nm to 4 rad/s and braking 6 Nm to 5 rad/s: the other is (1).
TEST(Envelope, OfPointsMeasuredBackwardsIsTheSameForwards) {
  const Actuator drive = actuator_of(
      R"({"points": [{"speed_rad_s": -4, "torque_Nm": 0}, {"speed_rad_s": 0, "torque_Nm": -8},
                     {"speed_rad_s": -5, "torque_Nm": 1}, {"speed_rad_s": 0, "torque_Nm": 6}]})");
  for (const double speed : {-3.0, -1.0}) {
    EXPECT_NEAR(at(drive, speed).least.torque_Nm, -line_Nm(8.0, 4.0, -speed), kRoundOff_Nm);
    EXPECT_NEAR(at(drive, speed).greatest.torque_Nm, 6.0 + speed, kRoundOff_Nm);
    EXPECT_EQ(at(drive, -speed).greatest.torque_Nm, -at(drive, speed).least.torque_Nm);
    EXPECT_EQ(at(drive, -speed).least.torque_Nm, -at(drive, speed).greatest.torque_Nm);
  }
}

// A bound that falls to 0 on both sides, 5 Nm at rest; it brakes up to 2 rad/s alone.
TEST(Envelope, OfPointsMayEndInNoTorqueWhereItBrakes) {
  const Actuator drive = actuator_of(
      R"({"points": [{"speed_rad_s": -2, "torque_Nm": 0}, {"speed_rad_s": 0, "torque_Nm": 5},
                     {"speed_rad_s": 10, "torque_Nm": 0}]})");
  EXPECT_NEAR(at(drive, -1.0).greatest.torque_Nm, 2.5, kRoundOff_Nm);
  EXPECT_NEAR(at(drive, -1.0).least.torque_Nm, -4.5, kRoundOff_Nm);
  EXPECT_NEAR(at(drive, 1.0).least.torque_Nm, -2.5, kRoundOff_Nm);
}

TEST(Envelope, GoesWithTheVoltageWhereItStatesOne) {
  const Actuator drive =
      actuator_of(R"({"peak_torque_Nm": 20, "no_load_speed_rad_s": 10, "voltage_V": 48})");
  const OperatingConditions half{Rating::kPeak, 24.0, {}, {}};
  EXPECT_NEAR(at(drive, 2.0, half).greatest.torque_Nm, 20.0 * (1.0 - 2.0 / 5.0), kRoundOff_Nm);
  EXPECT_TRUE(at(drive, 5.1, half).is_empty);
  const Actuator silent = actuator_of(R"({"peak_torque_Nm": 20, "no_load_speed_rad_s": 10})");
  ASSERT_EQ(objections(silent, half).size(), 1u);
  EXPECT_NE(objections(silent, half).front().find("/envelope/voltage_V"), std::string::npos);
}

// tau = eta (u - c) driving; the curve is u where losses are apart, tau where they are included.
TEST(Envelope, HoldsItsLossesOrLosesThem) {
  json document = document_of(R"({"peak_torque_Nm": 20, "maximum_speed_rad_s": 10})");
  document["gearbox"] = {{"ratio", 9}, {"forward_efficiency", 0.8}, {"backward_efficiency", 0.7}};
  document["effects"] = {{{"effect", "coulomb_friction"}, {"parameters", {{"coulomb_Nm", 1.5}}}}};
  const Actuator included = actuator_of(document);
  EXPECT_NEAR(at(included, 3.0).greatest.torque_Nm, 20.0, kRoundOff_Nm);
  EXPECT_NEAR(at(included, 3.0).least.torque_Nm, -20.0, kRoundOff_Nm);
  document["envelope"]["losses"] = "apart";
  const Actuator apart = actuator_of(document);
  EXPECT_NEAR(at(apart, 3.0).greatest.torque_Nm, 0.8 * (20.0 - 1.5), kRoundOff_Nm);
  EXPECT_NEAR(at(apart, 3.0).least.torque_Nm, -(20.0 + 1.5) / 0.7, kRoundOff_Nm);
}

TEST(Envelope, OfTheShaftGoesThroughTheGear) {
  json document =
      document_of(R"({"side": "motor", "peak_torque_Nm": 2, "no_load_speed_rad_s": 100})");
  for (const double ratio : {10.0, -10.0}) {
    document["gearbox"] = {{"ratio", ratio}};
    const Actuator drive = actuator_of(document);
    EXPECT_NEAR(at(drive, 5.0).greatest.torque_Nm, 10.0, kRoundOff_Nm) << ratio;
    EXPECT_NEAR(at(drive, 5.0).least.torque_Nm, -10.0, kRoundOff_Nm) << ratio;
  }
}

// 20 (1 - 6/10) = 8 Nm at 6 rad/s; with a ratio r times its own 20 r (1 - 6 r/10), which is 8.25
// where r^2 - r/0.6 + 0.6875 = 0; the root nearest to 1 is the greater one.
TEST(Envelope, SaysWhichRatioWouldReachANeed) {
  json document = document_of(R"({"peak_torque_Nm": 20, "no_load_speed_rad_s": 10})");
  document["gearbox"] = {{"ratio", 9}};
  const NeedAnswer answer = answer_need(actuator_of(document), {}, {8.25, 6.0});
  EXPECT_FALSE(answer.is_reached);
  EXPECT_FALSE(answer.least_current_A);
  ASSERT_TRUE(answer.nearest_ratio);
  const double p = 0.5 / 0.6, root = p + std::sqrt(p * p - 0.6875);
  EXPECT_NEAR(*answer.nearest_ratio / 9.0, root, 1e-6);
}

TEST(Envelope, LastsAsItsDocumentSays) {
  const Actuator drive = actuator_of(
      R"({"peak_torque_Nm": 20, "no_load_speed_rad_s": 10, "continuous_torque_Nm": 6})");
  const OperatingConditions lasting{Rating::kContinuous, {}, {}, {}};
  EXPECT_NEAR(at(drive, 2.0, lasting).greatest.torque_Nm, 6.0, kRoundOff_Nm);
  EXPECT_NEAR(at(drive, 9.0, lasting).greatest.torque_Nm, 2.0, kRoundOff_Nm);
  const Actuator silent = actuator_of(R"({"peak_torque_Nm": 20, "no_load_speed_rad_s": 10})");
  EXPECT_EQ(objections(silent, lasting).size(), 1u);
}

// Oracle: the same rows in the document, in SI units. 60 rpm are 2 pi rad/s.
TEST(Envelope, OfAFileTakesItsUnits) {
  const test::ScratchFolder folder;
  const auto read = [&](const std::string& table) {
    folder.write("curve.csv", table);
    const json document = document_of(R"({"points": "curve.csv"})");
    const std::string file = (folder.path() / "drive.json").string();
    return read_actuator(io::check_document(document, "actuator", file, "")).actuator;
  };
  const auto at_one_turn_a_second = [](const Actuator& drive) {
    return at(drive, 2.0 * std::numbers::pi).greatest.torque_Nm;
  };
  const std::string rows = "0;12\n60;8\n120;0\n";
  for (const std::string header :
       {"speed_rpm;torque_Nm\n", "Speed [rpm];Torque [Nm]\n", "Speed;torque\nrpm;Nm\n",
        "Curve of motor 3\n\nspeed;torque\n(rpm);(Nm)\n"}) {
    EXPECT_NEAR(at_one_turn_a_second(read(header + rows)), 8.0, kRoundOff_Nm) << header;
  }
  EXPECT_NEAR(at_one_turn_a_second(read("speed_rad_s,torque_Nm,torque_limit_Nm\n0,9,1\n20,9,1\n")),
              9.0, kRoundOff_Nm);
  EXPECT_NEAR(at_one_turn_a_second(read("speed_rad_s,torque_mNm\n0,9000\n20,9000\n")), 9.0,
              kRoundOff_Nm);
  const auto refused = [&](const std::string& table) {
    return test::refusal([&] { read(table); }, folder.path());
  };
  EXPECT_EQ(
      refused("speed,torque_Nm\n0,1\n1,0\n"),
      "curve.csv: the column \"speed\" states no unit; it must be one of rad/s, deg/s, rev/s or "
      "rpm");
  EXPECT_EQ(refused("rate_rad_s,torque_Nm\n0,1\n1,0\n"),
            "curve.csv: has no column speed; \"speed [rad/s]\" would be one");
  EXPECT_EQ(refused("speed_rad_s,speed_rpm,torque_Nm\n0,0,1\n1,9,0\n"),
            "curve.csv: speed_rad_s, speed_rpm are all called speed; one column must be");
}

TEST(Envelope, RefusesWhatIsNoCurve) {
  const std::vector<std::pair<const char*, const char*>> cases{
      {R"({"peak_torque_Nm": 20})", "/envelope/no_load_speed_rad_s: missing"},
      {R"({"no_load_speed_rad_s": 20})", "/envelope/peak_torque_Nm: missing"},
      {R"({"peak_torque_Nm": 20, "no_load_speed_rad_s": 9, "corner_speed_rad_s": 9})",
       "/envelope/corner_speed_rad_s: 9 rad/s is not below"},
      {R"({"peak_torque_Nm": 20, "no_load_speed_rad_s": 9, "corner_speed_rad_s": 4,
           "corner_torque_Nm": 21})",
       "/envelope/corner_torque_Nm: 21 Nm is above"},
      {R"({"peak_torque_Nm": 20, "no_load_speed_rad_s": 9, "maximum_speed_rad_s": 10})",
       "/envelope/maximum_speed_rad_s: 10 rad/s is above"},
      {R"({"peak_torque_Nm": 20, "no_load_speed_rad_s": 9, "continuous_torque_Nm": 20.5})",
       "/envelope/continuous_torque_Nm: 20.5 Nm is above"},
      {R"({"points": [{"speed_rad_s": 0, "torque_Nm": 5}, {"speed_rad_s": 0, "torque_Nm": 4}]})",
       "/envelope/points/1: 0 rad/s after 0 rad/s: torque must be a function"},
      {R"({"points": [{"speed_rad_s": 1, "torque_Nm": 5}, {"speed_rad_s": 3, "torque_Nm": 4}]})",
       "/envelope/points: they say nothing of rest"},
      {R"({"points": [{"speed_rad_s": 0, "torque_Nm": -5}, {"speed_rad_s": 0, "torque_Nm": 5},
                     {"speed_rad_s": 3, "torque_Nm": 4}]})",
       "/envelope/points: 1 of them have torque below 0; a bound needs two or more"},
      {R"({"points": [{"speed_rad_s": 0, "torque_Nm": 0}, {"speed_rad_s": 3, "torque_Nm": 4}]})",
       "/envelope/points: at rest torque goes from"},
      {R"({"points": [{"speed_rad_s": -4, "torque_Nm": 5}, {"speed_rad_s": 4, "torque_Nm": 5},
                      {"speed_rad_s": -4, "torque_Nm": -2}, {"speed_rad_s": 4, "torque_Nm": -2}],
           "peak_torque_Nm": 4})",
       "/envelope/peak_torque_Nm: stands beside \"points\""},
      {R"({"side": "motor", "losses": "included", "peak_torque_Nm": 20, "no_load_speed_rad_s": 9})",
       "/envelope/losses: a curve of the motor's shaft"},
  };
  for (const auto& [envelope, sentence] : cases) {
    EXPECT_NE(refusal(document_of(envelope)).find(sentence), std::string::npos)
        << envelope << refusal(document_of(envelope));
  }
}

TEST(Envelope, RefusesWhatNeedsAWinding) {
  json document = document_of(R"({"peak_torque_Nm": 20, "no_load_speed_rad_s": 9})");
  document["effects"] = {{{"effect", "torque_constant_error"}, {"parameters", {{"factor", 1.1}}}}};
  EXPECT_NE(refusal(document).find("f#/effects/0: torque_constant_error acts on a winding"),
            std::string::npos)
      << refusal(document);
  document.erase("effects");
  document["thermal"] = {{"winding_to_case_K_W", 1},
                         {"case_to_ambient_K_W", 1},
                         {"winding_J_K", 50},
                         {"case_J_K", 500},
                         {"winding_limit_K", 400}};
  EXPECT_NE(refusal(document).find("f#/thermal: stands beside an envelope"), std::string::npos);
  const json bare = {{"kind", "actuator"}, {"version", 1}};
  EXPECT_NE(refusal(bare).find("\"envelope\" where only the curve is known"), std::string::npos);
}

}  // namespace
}  // namespace torquewright::actuator
