// SPDX-License-Identifier: Apache-2.0
// Wrong actuators and trajectories as users hand them in: exit 2 with file, place, value and what
// is allowed, or a finding that names the trouble; never NaN. One case for each slip that is known.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <regex>

#include "tests/cli/workplace.hpp"

namespace torquewright::cli_test {
namespace {

using nlohmann::json;

std::string d151() { return text_of(in_repository("specs/actuator/d151_knee.json")); }

const std::string kHeader = "time_s,knee_velocity_rad_s,knee_torque_Nm\n";

/// The D151's actuator with one place changed, and what is said of it.
struct BadActuator {
  std::string from, to, fault;
};
void PrintTo(const BadActuator& bad, std::ostream* stream) { *stream << bad.to; }

class WrongActuator : public testing::TestWithParam<BadActuator> {};

TEST_P(WrongActuator, IsRefusedWithItsPlace) {
  const Workplace place;
  place.write("knee.json", with(d151(), GetParam().from, GetParam().to));
  place.write("m.csv", kHeader + "0,1,1\n1,1,1\n");
  const std::vector<std::vector<std::string>> commands = {
      {"actuator", "mor", "knee.json", "-o", "out"},
      {"actuator", "mor", "knee.json", "--format", "mujoco", "-o", "out"},
      {"actuator", "lint", "knee.json"},
      {"actuator", "check", "m.csv", "--joint", "knee=knee.json", "-o", "out"}};
  for (const std::vector<std::string>& command : commands) {
    const Outcome outcome = place.run(command);
    EXPECT_EQ(outcome.exit_code, 2) << command[1];
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(outcome.err, "knee.json" + GetParam().fault + "\n");
    EXPECT_FALSE(place.has("out"));
  }
}

INSTANTIATE_TEST_SUITE_P(
    Each, WrongActuator,
    testing::Values(
        BadActuator{"\"resistance_ohm\": 0.28", "\"resistance_ohm\": 0",
                    "#/motor/resistance_ohm: 0 is outside [1e-05, 1000] ohm"},
        BadActuator{"\"rotor_inertia_kg_m2\": 0.000922", "\"rotor_inertia_kg_m2\": -0.000922",
                    "#/motor/rotor_inertia_kg_m2: -0.000922 is outside [0, 10] kg m^2"},
        // mNm/A.
        BadActuator{"\"torque_constant_Nm_A\": 0.32", "\"torque_constant_Nm_A\": 320",
                    "#/motor/torque_constant_Nm_A: 320 is outside [1e-05, 10] Nm/A"},
        BadActuator{"\"torque_constant_convention\": \"dc\"",
                    "\"torque_constant_convention\": \"rms\"",
                    "#/motor/torque_constant_convention: \"rms\" is not one of \"dc\", "
                    "\"peak_phase\", \"rms_phase\""},
        BadActuator{"\"resistance_convention\": \"dc\",", "",
                    "#/motor/resistance_convention: missing, must be \"dc\", \"phase\" or "
                    "\"line_to_line\""},
        BadActuator{"\"rotor_inertia_kg_m2\"", "\"rotor_inertia_kgm2\"",
                    "#/motor/rotor_inertia_kgm2: unknown key; did you mean "
                    "\"rotor_inertia_kg_m2\"?"},
        BadActuator{"\"ratio\": 20", "\"ratio\": 0",
                    "#/gearbox/ratio: 0 is no ratio; must be at least 0.01 in magnitude"},
        BadActuator{"\"forward_efficiency\": 1", "\"forward_efficiency\": 97",
                    "#/gearbox/forward_efficiency: 97 is outside [0.01, 1]"},
        BadActuator{"\"bus_voltage_V\": 67.2", "\"bus_voltage_V\": \"67.2\"",
                    "#/drive/bus_voltage_V: is a string, must be a number"},
        BadActuator{"0.32", "0,32",
                    ": line 2, column 39: not JSON: a decimal comma? write 1.5, "
                    "not 1,5"},
        BadActuator{"0.28", "NaN",
                    "#/motor/resistance_ohm: NaN is not a JSON number, must be finite (line 3, "
                    "column 22)"}));

// Small motors have so little that the schema's limit lets it through; the lint names it. By hand:
// a motor of 8.2 Nm/A turns with 24/8.2 = 2.9 rad/s, one of 0.0082 with 2900.
TEST(TorqueConstant, InMilliIsNamedByTheLint) {
  const Workplace place;
  const std::string small = with(d151(), "\"bus_voltage_V\": 67.2", "\"bus_voltage_V\": 24");
  const auto lint = [&](const char* torque_constant) {
    place.write("knee.json", with(small, "\"torque_constant_Nm_A\": 0.32",
                                  std::string("\"torque_constant_Nm_A\": ") + torque_constant));
    return place.run({"actuator", "lint", "knee.json"});
  };
  const Outcome outcome = lint("8.2");
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_NE(outcome.out.find("warning: knee D151: torque-constant-unit: "), std::string::npos)
      << outcome.out;
  EXPECT_NE(outcome.out.find("written in mNm/A"), std::string::npos);
  EXPECT_EQ(lint("0.0082").out.find("torque-constant-unit"), std::string::npos);
  EXPECT_EQ(lint("4.7").out.find("torque-constant-unit"), std::string::npos);
  EXPECT_NE(lint("4.9").out.find("torque-constant-unit"), std::string::npos);
}

/// A battery of 16 cells in one string, of that resistance each.
std::string on_battery(const std::string& cell_ohm) {
  std::string text = d151();
  return text.insert(text.rfind('}'), R"(, "battery": {"series_cells": 16, "parallel_cells": 1,
    "cell_open_circuit_V": 4.2, "cell_resistance_ohm": )" +
                                          cell_ohm + "}");
}

// Oracle: the most that a source behind a resistance delivers is Voc^2 / 4 R: 67.2^2 / 32 = 141.12
// W here; at rest all of it is copper loss, R i^2 with R = 0.28.
TEST(Battery, ThatCannotDeliverIsTheNamedLimiter) {
  const Workplace place;
  place.write("knee.json", on_battery("0.5"));
  const Outcome outcome =
      place.run({"actuator", "mor", "knee.json", "--at-speed", "0,5,10.4", "--json"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.err, "");
  EXPECT_EQ(outcome.out.find("nan"), std::string::npos);
  const json rows = json::parse(outcome.out)["rows"];
  EXPECT_EQ(rows[0]["limiter_max"], "battery_power");
  EXPECT_NEAR(rows[0]["bus_power_at_max_W"].get<double>(), 141.12, 1e-6);
  EXPECT_NEAR(rows[0]["current_max_A"].get<double>(), std::sqrt(141.12 / 0.28), 1e-6);
  EXPECT_EQ(rows[1]["limiter_max"], "battery_power");
  place.write("m.csv", kHeader + "0,5,300\n1,5,300\n");
  const Outcome check = place.run({"actuator", "check", "m.csv", "--joint", "knee=knee.json"});
  EXPECT_EQ(check.exit_code, 1);
  EXPECT_NE(check.out.find("(battery_power)"), std::string::npos) << check.out;
  EXPECT_EQ(check.out.find("nan"), std::string::npos);
}

struct BadMotion {
  std::string text, fault;
};
void PrintTo(const BadMotion& bad, std::ostream* stream) { *stream << bad.fault; }

class Motion : public testing::TestWithParam<BadMotion> {};

TEST_P(Motion, IsRefusedWithItsPlace) {
  const Workplace place;
  place.write("knee.json", d151());
  place.write("m.csv", GetParam().text);
  const Outcome outcome =
      place.run({"actuator", "check", "m.csv", "--joint", "knee=knee.json", "-o", "out"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(outcome.err, "m.csv: " + GetParam().fault + "\n");
  EXPECT_FALSE(place.has("out"));
}

INSTANTIATE_TEST_SUITE_P(
    Each, Motion,
    testing::Values(
        BadMotion{kHeader + "0,5,nan\n",
                  "line 2, column 3 (knee_torque_Nm): \"nan\" is not a finite number"},
        BadMotion{kHeader + "0,1,1\n1,-inf,1\n",
                  "line 3, column 2 (knee_velocity_rad_s): \"-inf\" is not a finite number"},
        BadMotion{kHeader + "0,1,1\n0,1,1\n",
                  "line 3, column 1 (time_s): time repeats: 0 s follows 0 s of line 2"},
        BadMotion{kHeader + "0,1,1\n1,1,1\n0.5,1,1\n",
                  "line 4, column 1 (time_s): time runs backwards: 0.5 s follows 1 s of line 3"},
        BadMotion{kHeader + "0,1\n", "line 2: has 2 cells, the header has 3"},
        BadMotion{kHeader + "0.1,1,1,1\n", "line 2: has 4 cells, the header has 3"},
        BadMotion{kHeader + "0,1,1\n" + kHeader + "1,1,1\n",
                  "line 3: the header stands here again; one file holds one table"},
        BadMotion{"time_s,knee_torque_Nm,knee_torque_Nm\n0,1,1\n",
                  "line 1, column 3 (knee_torque_Nm): the name \"knee_torque_Nm\" stands twice in "
                  "the header"},
        BadMotion{kHeader + "\"0,5\",1,1\n",
                  "line 2, column 1 (time_s): \"0,5\" has a decimal comma; write 1.5, not 1,5"},
        BadMotion{kHeader + "0,5,1,1\n",
                  "line 2: has 4 cells, the header has 3; decimal commas? write 1.5, not 1,5, or "
                  "separate by semicolons"},
        BadMotion{
            "time_s;knee_velocity_rad_s;knee_torque_Nm\n0;1,5;1.5\n",
            "line 2, column 3 (knee_torque_Nm): \"1.5\" has a decimal point, and cells before "
            "it have commas"},
        BadMotion{
            kHeader + "s,rpm,Nm\n0,1,1\n",
            "the name \"knee_velocity_rad_s\" says rad/s, the row of units below it says rpm; "
            "correct one or delete the row"},
        BadMotion{kHeader + "s,rad/s,A\n0,1,1\n",
                  "the row of units says A at \"knee_torque_Nm\", whose unit must be Nm, mNm, kNm, "
                  "Ncm, kgf_cm, ozf_in, lbf_in or lbf_ft"},
        BadMotion{"time_s,kne_velocity_rad_s\n0,1\n", "no joint \"knee\"; did you mean \"kne\"?"},
        BadMotion{"t," + kHeader + "0,0,1,1\n1,0.1,1,1\n",
                  "\"t\" and \"time_s\" may both be the time; say which it is, --column "
                  "time_s=time:s or --column t=time:s"},
        BadMotion{"", "is empty; the first line must name the columns"},
        BadMotion{kHeader, "holds a header and no rows"}));

// What other systems' editors add is no mistake.
TEST(GoodMotion, MayHaveAByteOrderMarkAndForeignLineEnds) {
  const Workplace place;
  place.write("knee.json", d151());
  const std::string text = kHeader + "0,1,1\n1,1,1\n2,3,1\n";
  const auto answer = [&](const std::string& motion) {
    place.write("m.csv", motion);
    return place.run({"actuator", "check", "m.csv", "--joint", "knee=knee.json"}).out;
  };
  const std::string plain = answer(text);
  EXPECT_NE(plain.find("pass"), std::string::npos);
  EXPECT_EQ(answer("\xEF\xBB\xBF" + text), plain);
  EXPECT_EQ(answer(std::regex_replace(text, std::regex("\n"), "\r\n")), plain);
}

// A fall of 1.4 rad in 0.14 s, twice as fast as the D151 can turn, logged with a velocity of 0.
TEST(DeadVelocity, IsRefused) {
  const Workplace place;
  place.write("knee.json", d151());
  std::string text = "time_s,knee_position_rad,knee_velocity_rad_s,knee_torque_Nm\n";
  for (int i = 0; i <= 70; ++i) {
    const double share = i / 70.0;
    text += std::to_string(0.14 * share) + "," + std::to_string(1.6 - 1.4 * share) + ",0,1\n";
  }
  place.write("m.csv", text);
  const Outcome outcome = place.run({"actuator", "check", "m.csv", "--joint", "knee=knee.json"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(
      outcome.err,
      "m.csv: the velocity of knee is not the rate of its position: from t = 0 s to 0.14 s the "
      "position changes by -1.4 rad and the integral of the velocity by 0 rad; one of the "
      "columns may be dead, late or another joint's, or a position noisy. Mend the column that is "
      "wrong (--column states a unit and a factor), or take knee's velocity out of the file: then "
      "the slopes of the position are taken\n");
}

// Degrees under a header in rad: 6 rad/s are 344 deg/s, beyond what the knee can turn.
TEST(SuspiciousMotion, InDegreesIsWarnedOf) {
  const Workplace place;
  place.write("knee.json", d151());
  place.write("m.csv", kHeader + "0,300,1\n1,344,1\n");
  const Outcome outcome = place.run({"actuator", "check", "m.csv", "--joint", "knee=knee.json"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_NE(outcome.out.find("warning [speed-implausible] knee: speeds reach 344 rad/s"),
            std::string::npos)
      << outcome.out;
  EXPECT_NE(outcome.out.find("degrees under a header in rad?"), std::string::npos);
}

// A row of units counts where names say none; dates are times. Oracle: the same motion in SI.
TEST(MotionAsLogged, IsTheSameInItsUnitsAndDates) {
  const Workplace place;
  place.write("knee.json", d151());
  place.write("si.csv", "time_s,knee_velocity_rad_s,knee_torque_Nm\n0,1,40\n0.5,2,50\n1,1.5,45\n");
  place.write("units.csv",
              "time;knee_w;knee_t\nms;1/min;N\u00b7cm\n0;9,549296585513721;4000\n"
              "500;19,098593171027442;5000\n1000;14,323944878270581;4500\n");
  place.write("dates.csv",
              "time_s,knee_velocity_rad_s,knee_torque_Nm\n2026-05-04T10:00:00,1,40\n"
              "2026-05-04T10:00:00.5,2,50\n2026-05-04T10:00:01,1.5,45\n");
  const auto checked = [&](const std::string& file, const std::vector<std::string>& more) {
    std::vector<std::string> words{"actuator", "check",          file,
                                   "--joint",  "knee=knee.json", "--json"};
    words.insert(words.end(), more.begin(), more.end());
    const Outcome outcome = place.run(words);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return json::parse(outcome.out)["joints"][0];
  };
  const json expected = checked("si.csv", {});
  for (const json& joint : {checked("units.csv", {"--column", "knee_w=knee.velocity", "--column",
                                                  "knee_t=knee.torque"}),
                            checked("dates.csv", {})}) {
    EXPECT_EQ(joint["samples"], expected["samples"]);
    for (const char* key : {"margin_Nm", "peak_torque_Nm", "rms_torque_Nm"}) {
      EXPECT_NEAR(joint[key].get<double>(), expected[key].get<double>(), 1e-6) << key;
    }
  }
}

// Also where it is a robot's: no table of it has an end.
TEST(LockedGearbox, IsRefusedWithoutALimitOfItsTeeth) {
  const Workplace place;
  fs::copy(in_repository("specs"), place.path("specs"), fs::copy_options::recursive);
  const std::string knee = text_of(in_repository("specs/actuator/d151_knee.json"));
  const std::string key = "\"backward_efficiency\": ";
  const std::size_t from = knee.find(key);
  ASSERT_NE(from, std::string::npos);
  const std::string stated = knee.substr(from, knee.find_first_of(",}", from) - from);
  for (const char* efficiency : {"0", "5e-324"}) {
    place.write("specs/actuator/d151_knee.json", with(knee, stated, key + efficiency));
    for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{
             {"actuator", "mor", "specs/actuator/d151_knee.json", "--at-speed", "0"},
             {"robot", "export", "specs/robot/hopper.json", "--format", "mjcf", "--actuators"},
             {"robot", "export", "specs/robot/hopper.json", "--format", "newton", "--actuators"}}) {
      const Outcome outcome = place.run(words);
      EXPECT_EQ(outcome.exit_code, 2) << words[0];
      EXPECT_EQ(outcome.out, "");
      EXPECT_NE(outcome.err.find("d151_knee.json: the gearbox locks itself"), std::string::npos)
          << outcome.err;
    }
  }
}

}  // namespace
}  // namespace torquewright::cli_test
