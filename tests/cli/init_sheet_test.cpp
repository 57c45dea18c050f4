// SPDX-License-Identifier: Apache-2.0
// `init actuator --from-sheet` with lines in the place of a terminal. Oracles: closed forms of the
// region that `actuator mor` computes from the document, and the shell that pipes the lines.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <numbers>

#include "tests/cli/workplace.hpp"

namespace torquewright::cli_test {
namespace {

using nlohmann::json;

/// The program, fed with lines in a folder of its own.
struct Desk : Workplace {
  Outcome answer(const std::string& lines) const {
    write("lines.txt", lines);
    const std::string command =
        "cd '" + path().string() +
        "' && '" TORQUEWRIGHT_PROGRAM
        "' init actuator --from-sheet -o a.json < lines.txt > out.txt 2> err.txt";
    Outcome outcome;
    const int status = std::system(command.c_str());
    if (WIFEXITED(status)) outcome.exit_code = WEXITSTATUS(status);
    outcome.out = text("out.txt");
    outcome.err = text("err.txt");
    return outcome;
  }

  json document() const { return json::parse(text("a.json")); }

  json row_at(const std::string& speed_rad_s) const {
    const Outcome outcome = run({"actuator", "mor", "a.json", "--at-speed", speed_rad_s, "--json"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return json::parse(outcome.out)["rows"].front();
  }
};

constexpr double kRoundOff = 1e-9;  // of the twelve digits that tables print

// Kv and peak torque alone. At rest there is the torque that was typed; nothing is left where
// V = Ke w, at 48 V times 100 rpm/V over 9, and just below there still is.
TEST(InitFromSheet, TakesASheetWithKvAndPeakTorqueAlone) {
  const Desk desk;
  const Outcome outcome =
      desk.answer("48 V\n9:1\n30 Nm\n530 rpm\n\n100 rpm/V\n170 mohm\n\n22 A_rms\n607 g cm^2\n");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  const json document = desk.document();
  EXPECT_EQ(document["motor"]["velocity_constant_rpm_V"],
            (json{{"value", 100}, {"unit", "rpm/V"}}));
  EXPECT_EQ(document["motor"]["resistance_convention"], "line_to_line");
  EXPECT_NEAR(desk.row_at("0")["torque_max_Nm"].get<double>(), 30.0, 30.0 * kRoundOff);
  const double no_load_rad_s = 48.0 * 100.0 / 9.0 * std::numbers::pi / 30.0;
  const auto driving_at = [&](double share) {
    return desk.row_at(std::to_string(share * no_load_rad_s))["torque_max_Nm"].get<double>();
  };
  EXPECT_GT(driving_at(0.999), 0.0);
  EXPECT_LE(driving_at(1.001), 0.0);
  EXPECT_NE(outcome.out.find("60 / (2 pi Kv)"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("next: torquewright actuator mor a.json"), std::string::npos);
  EXPECT_NE(desk.run({"actuator", "mor", "a.json"}).out.find("T / (Kt N eta)"), std::string::npos);
}

// Both constants name the ampere: 60 / (2 pi Kv Kt) is 1 of the dc winding, 2 / sqrt(3) of the
// amplitude, sqrt(2 / 3) of the rms (docs/derivations/conventions.md).
TEST(InitFromSheet, TellsTheAmpereFromBothConstants) {
  const double winding_Nm_A = 30.0 / (std::numbers::pi * 100.0);
  const std::pair<double, const char*> cases[] = {{1.0, "dc"},
                                                  {std::sqrt(3.0) / 2.0, "peak_phase"},
                                                  {std::sqrt(3.0 / 2.0), "rms_phase"},
                                                  {1.06 * std::sqrt(3.0 / 2.0), "rms_phase"}};
  for (const auto& [factor, convention] : cases) {
    const Desk desk;
    const Outcome outcome =
        desk.answer("48 V\n9\n\n\n" + std::to_string(1e3 * factor * winding_Nm_A) +
                    " mNm_A\n100\n0.085 ohm phase\n30 A\n\n\n");
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const json document = desk.document();
    EXPECT_EQ(document["motor"]["torque_constant_convention"], convention) << factor;
    EXPECT_EQ(document["motor"]["resistance_convention"], "phase");
    EXPECT_EQ(document["drive"].contains("modulation"), std::string(convention) != "dc");
    EXPECT_EQ(desk.run({"actuator", "lint", "a.json"}).exit_code, 0);
  }
}

TEST(InitFromSheet, WritesTheCurveWhereTheWindingIsNotKnown) {
  const Desk desk;
  const Outcome outcome = desk.answer("48 V\n\n30 Nm\n10 rad/s\n\n\n\n30 A_rms\n\n\n");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_TRUE(desk.document().contains("envelope"));
  EXPECT_NE(outcome.out.find("Not used: Peak current.\n"), std::string::npos) << outcome.out;
  EXPECT_NEAR(desk.row_at("5")["torque_max_Nm"].get<double>(), 15.0, 15.0 * kRoundOff);
}

// Torque at rest: Kt I through gears of that ratio and efficiency, as `gearbox evaluate` has them.
TEST(InitFromSheet, TakesAGearboxForTheRatio) {
  const Desk desk;
  const std::string result = in_repository("specs/gearbox/d151_knee_result.json").string();
  const Outcome outcome = desk.answer("48 V\n" + result + "\n\n\n0.1 Nm_A\n\n0.1 ohm\n30 A\n\n\n");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const json design = json::parse(text_of(result))["designs"][0];
  const double torque_Nm = 0.1 * 30.0 * 20.0 * design["forward_efficiency"].get<double>();
  EXPECT_NEAR(desk.row_at("0.001")["torque_max_Nm"].get<double>(), torque_Nm, 1e-9 * torque_Nm);
  const json assumed = desk.document()["assumed"];
  EXPECT_EQ(std::count(assumed.begin(), assumed.end(), "/gearbox/forward_efficiency"), 0);
  for (const char* wrong : {"nothing.json", "lines.txt.json"}) {
    const Desk other;
    other.write("lines.txt.json", "{}");
    const Outcome refused =
        other.answer(std::string("48 V\n") + wrong + "\n\n\n0.1\n\n0.1\n30 A\n\n\n");
    EXPECT_EQ(refused.exit_code, 2);
    EXPECT_TRUE(refused.err.starts_with("standard input, line 2 (Gear ratio): \"")) << refused.err;
    EXPECT_FALSE(other.has("a.json"));
  }
}

// "> 30 Nm" stays a bound in the document, which the region takes for the number; 20 A from 48 V
// are 960 W, so that K w i + R i^2 = 960 with K = 9 Kt, where the current would allow more.
TEST(InitFromSheet, TakesBoundsAndASupplysCurrent) {
  const Desk desk;
  const Outcome outcome =
      desk.answer("48 V, 20 A\n9\n> 30 Nm\n\n\n100\n170 mohm\n\n\n<= 607 gcm2\n");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const json document = desk.document();
  EXPECT_EQ(document["drive"]["supply_current_A"], (json{{"value", 20}, {"unit", "A"}}));
  EXPECT_EQ(document["drive"]["peak_torque_Nm"],
            (json{{"value", 30}, {"unit", "Nm"}, {"bound", "at_least"}}));
  EXPECT_EQ(document["motor"]["rotor_inertia_kg_m2"]["bound"], "at_most");
  EXPECT_NE(outcome.out.find("/drive/peak_torque_Nm: the sheet says at least that"),
            std::string::npos)
      << outcome.out;
  EXPECT_NEAR(desk.row_at("0")["torque_max_Nm"].get<double>(), 30.0, 30.0 * kRoundOff);
  const double K = 9.0 * 30.0 / (std::numbers::pi * 100.0), R = 0.17, w = 30.0;
  const double i = (-K * w + std::sqrt(K * w * K * w + 4.0 * R * 960.0)) / (2.0 * R);
  const json row = desk.row_at("30");
  EXPECT_NEAR(row["torque_max_Nm"].get<double>(), K * i, K * i * kRoundOff);
  EXPECT_EQ(row["limiter_max"], "battery_power");
}

// A bound of a number that others follow from goes to the data sheet, where the lint reads it: 30 A
// give 25.8 Nm, and so not more than 40, but more than 20.
TEST(InitFromSheet, LeavesABoundToTheLintWhereTheRegionNeedsNone) {
  for (const auto& [bound, code] : {std::pair{"> 20 Nm", 0}, {"> 40 Nm", 1}, {"< 40 Nm", 0}}) {
    const Desk desk;
    const Outcome outcome =
        desk.answer(std::string("48 V\n9\n") + bound + "\n\n\n100\n170 mohm\n30 A\n\n\n");
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(desk.run({"actuator", "lint", "a.json"}).exit_code, code) << bound;
  }
}

// Sheets as makers print them. Oracle: what each number is in the unit of its key, by the
// definitions of ounce, inch and standard gravity.
TEST(InitFromSheet, ReadsNumbersAndUnitsAsMakersPrintThem) {
  struct Case {
    const char* lines;
    const char* pointer;
    double value;
    const char* unit;
  };
  const Case cases[] = {
      {"22.2 VDC\n\n\n\n\n380KV\n47 m\u03a9\n40 A\n-\nn/a\n", "/motor/resistance_ohm", 47, "mohm"},
      {"22.2 V\n\n\n\n\nKV380\n47 mOhm\n40 A\n\n\n", "/motor/velocity_constant_rpm_V", 380,
       "rpm/V"},
      {"48 V\n\n1,46 N\u00b7m\n\n109 mNm/A\n\n0.463 \u03a9\n\n\n506 g\u00b7cm\u00b2\n",
       "/drive/peak_torque_Nm", 1.46, "Nm"},
      {"48 V\n1:9\n\n3 820 min\u207b\u00b9\n0.1 Nm/Arms\n\n0.1 ohm\n60 Arms\n\n"
       "6.1\u00d710\u207b\u2075 kg\u00b7m\u00b2\n",
       "/motor/rotor_inertia_kg_m2", 6.1e-5, "kgm2"},
      {"48 V\n\n\n3 820 min\u207b\u00b9\n0.1 Nm/A\n\n0.1 ohm\n60 A\n\n\n",
       "/datasheet/no_load_speed_rad_s", 3820, "rpm"},
      {"24 V\n\n320 oz-in\n\n6.8 oz-in/A\n\n0.21 Ohms\n\n\n\n", "/motor/torque_constant_Nm_A", 6.8,
       "ozf_in/A"}};
  for (const Case& each : cases) {
    const Desk desk;
    const Outcome outcome = desk.answer(each.lines);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const json stated = desk.document()[json::json_pointer(each.pointer)];
    EXPECT_DOUBLE_EQ(stated["value"].get<double>(), each.value) << each.lines;
    EXPECT_EQ(stated["unit"], each.unit) << each.lines;
    EXPECT_EQ(desk.run({"actuator", "mor", "a.json"}).exit_code, 0) << each.lines;
  }
}

// What a sheet says beside its numbers is said to be left aside.
TEST(InitFromSheet, LeavesRemarksAside) {
  const Desk desk;
  const Outcome outcome = desk.answer(
      "48 V nominal\n9:1 planetary\n\n\nKt = 0.11 Nm/A\n\n0.17 ohm @ 25 \u00b0C\n30 A for 10 "
      "s\n\n\n");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const json document = desk.document();
  EXPECT_EQ(document["gearbox"]["ratio"], 9);
  EXPECT_EQ(document["motor"]["resistance_ohm"], (json{{"value", 0.17}, {"unit", "ohm"}}));
  EXPECT_EQ(document["drive"]["peak_current_A"], (json{{"value", 30}, {"unit", "A"}}));
  for (const char* said :
       {"Supply voltage: \"nominal\" is left aside.", "Gear ratio: \"planetary\"",
        "Resistance: \"@ 25 \u00b0C\"", "Peak current: \"for 10 s\""}) {
    EXPECT_NE(outcome.out.find(said), std::string::npos) << said << outcome.out;
  }
}

// 6.8 ozf in/A and 10 A, behind nothing: 68 ounces of force an inch away.
TEST(InitFromSheet, ReckonsInOuncesAndInches) {
  const Desk desk;
  ASSERT_EQ(desk.answer("24 V\n\n\n\n6.8 oz-in/A\n\n0.21 Ohms\n10 A\n\n\n").exit_code, 0);
  const double torque_Nm = 68.0 * 0.45359237 / 16.0 * 9.80665 * 0.0254;
  EXPECT_NEAR(desk.row_at("0")["torque_max_Nm"].get<double>(), torque_Nm, 1e-9 * torque_Nm);
}

// A constant per rms ampere says so itself: 0.1 Nm/Arms and 60 A of it behind 9:1.
TEST(InitFromSheet, TakesTheAmpereOfTheConstantsUnit) {
  const Desk desk;
  const Outcome outcome =
      desk.answer("48 V\n1:9\n\n\n0.1 Nm/Arms\n\n0.1 \u03a9 phase-phase\n60 A\n\n\n");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const json document = desk.document();
  EXPECT_EQ(document["motor"]["torque_constant_convention"], "rms_phase");
  EXPECT_EQ(document["motor"]["resistance_convention"], "line_to_line");
  const json& assumed = document["assumed"];
  EXPECT_EQ(std::count(assumed.begin(), assumed.end(), "/motor/torque_constant_convention"), 0);
  EXPECT_NEAR(desk.row_at("0")["torque_max_Nm"].get<double>(), 54.0, 54.0 * kRoundOff);
}

// Nothing is written where an answer is no number, of another unit, too few or too many.
TEST(InitFromSheet, RefusesWhatIsNoSheet) {
  struct Case {
    std::string lines, said;
  };
  const Case cases[] = {
      {"48 V\n9\n\n\n\n100\nsome\n\n\n\n",
       "standard input, line 7 (Resistance): \"some\": it does not begin with a number"},
      {"48 V\n9\n\n\n\n100\n93 mohmm\n30 A\n\n\n",
       "(Resistance): \"93 mohmm\": \"mohmm\" is not one of ohm, mohm"},
      {"-48 V\n9\n\n\n\n100\n93 mohm\n30 A\n\n\n",
       "standard input, line 1 (Supply voltage): \"-48 V\": "},
      {"> 48 V\n9\n\n\n\n100\n93 mohm\n30 A\n\n\n", "\"> 48 V\": Supply voltage is a number"},
      {"48 V, some\n9\n\n\n\n100\n93 mohm\n30 A\n\n\n",
       "\"some\": it does not begin with a number; as an example: 20 A"},
      {"48 V\n9\n", "standard input: ends before answer 3 of 10 (Peak torque)"},
      {"6S\n9\n\n\n\n100\n93 mohm\n30 A\n\n\n",
       "\"6S\": a count of cells; of lithium cells 6 are 22.2 V"},
      {"48 V\n9\n\n\n\n7.2 V/krpm\n93 mohm\n30 A\n\n\n",
       "\"7.2 V/krpm\": a back-EMF constant; where its volts are the amplitude between two leads, "
       "Kv "
       "is 138.9 rpm/V"},
      {"48 V\n9\n\n\n\n100\n93 N\u00b7mm\n30 A\n\n\n", "\"N\u00b7mm\" is not one of ohm, mohm"},
      {"24-48 V\n9\n\n\n\n100\n93 mohm\n30 A\n\n\n", "\"24-48 V\": it is a range"},
      {"48 V\n9\n\n4,820 rpm\n\n100\n93 mohm\n30 A\n\n\n",
       "\"4,820 rpm\": the comma may stand for thousands or for decimals; write 4820 or 4.820"},
      {"48 V\n9\n\n\n\n100\n93 Mohm\n30 A\n\n\n", "\"Mohm\" is not one of ohm, mohm"},
      {"", "standard input: ends before answer 1 of 10"},
      {"48 V\n9\n\n\n\n100\n93 mohm\n30 A\n\n\n7\n",
       "standard input: goes on after 10 answers with \"7\""},
      {"\n\n\n\n\n\n\n\n\n\n", "init --from-sheet: the answers are too few"},
      {"48 V\n9\n30 Nm\n\n\n100\n\n\n\n\n", "init --from-sheet: the answers are too few"}};
  for (const Case& each : cases) {
    const Desk desk;
    const Outcome outcome = desk.answer(each.lines);
    EXPECT_EQ(outcome.exit_code, 2) << each.lines << outcome.out;
    EXPECT_NE(outcome.err.find(each.said), std::string::npos) << each.said << "\n" << outcome.err;
    EXPECT_FALSE(desk.has("a.json")) << each.lines;
  }
  const Workplace place;
  EXPECT_EQ(place.run({"init", "rig", "--from-sheet"}).exit_code, 2);
}

}  // namespace
}  // namespace torquewright::cli_test
