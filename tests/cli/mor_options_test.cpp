// SPDX-License-Identifier: Apache-2.0
// Options of `actuator mor` that go together are done together, all others are refused; what a
// file's name ends in is what is in it.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/cli/workplace.hpp"

namespace torquewright::cli_test {
namespace {

const std::string kKnee = in_repository("specs/actuator/d151_knee.json").string();

Outcome mor(const Workplace& place, std::vector<std::string> more) {
  more.insert(more.begin(), {"actuator", "mor", kKnee});
  return place.run(more);
}

TEST(MorOptions, OnesThatWouldBeDroppedAreRefused) {
  const Workplace place;
  const std::vector<std::vector<std::string>> dropped{
      {"--need", "200@10", "--format", "mujoco"}, {"--need", "200@10", "--at-speed", "1"},
      {"--need", "200@10", "--side", "motor"},    {"--need", "200@10", "--accuracy", "0.1"},
      {"--ratio", "4:40", "--plot", "x.svg"},     {"--ratio", "4:40", "--format", "json"},
      {"--compare", kKnee, "--format", "csv"},    {"--fit", "best"},
      {"--fit", "best", "--format", "csv"},       {"--at-speed", "1", "--accuracy", "0.1"},
      {"--at-speed", "1", "--format", "mujoco"},  {"--format", "csv", "--json"},
      {"--format", "csv", "-o", "x.json"},        {"--json", "-o", "x.csv"}};
  for (const std::vector<std::string>& options : dropped) {
    const Outcome outcome = mor(place, options);
    EXPECT_EQ(outcome.exit_code, 2) << options[0] << ' ' << options[2 % options.size()];
    EXPECT_NE(outcome.err, "");
    EXPECT_TRUE(place.files().empty());
  }
}

// Oracle: the knee's line in closed form, 1536 (1 - w / 10.5) Nm under 320 Nm: they meet at 8.3125
// rad/s, and 320 Nm there are 2660 W.
TEST(MorOptions, OneScreenSaysTheRegionWhereNothingMoreIsAsked) {
  const Workplace place;
  const std::string screen = mor(place, {}).out;
  for (const char* line :
       {"at rest      320 Nm\n", "no load      10.5 rad/s\n",
        "most power   2660 W at 8.313 rad/s\n",
        "limited by   current to 8.313 rad/s, where 320 Nm are left, then voltage\n",
        "backward     the same\n", "region ends  at 12.69 rad/s: up to there torque brakes\n",
        "for ever     128 Nm at rest", "assumed      /motor/"}) {
    EXPECT_NE(screen.find(line), std::string::npos) << line << screen;
  }
  EXPECT_LE(std::count(screen.begin(), screen.end(), '\n'), 20);
  EXPECT_EQ(mor(place, {"--table"}).out, mor(place, {"--format", "csv"}).out);
  EXPECT_EQ(mor(place, {"--accuracy", "0.1"}).out,
            mor(place, {"--table", "--accuracy", "0.1"}).out);
}

// Oracle: 10 rad/s are 300 / pi rpm; 2 kN and 1 m/s at 0.1 m are 200 Nm and 10 rad/s.
TEST(MorOptions, NeedsHaveTheUnitsThatPeopleHave) {
  const Workplace place;
  const std::string plain = mor(place, {"--need", "200@10"}).out;
  EXPECT_EQ(mor(place, {"--need", "200000mNm@95.49296585513721rpm"}).out, plain);
  EXPECT_EQ(mor(place, {"--need", "2kN@1m_s", "--lever", "0.1"}).out, plain);
  EXPECT_EQ(mor(place, {"--need", "2kN@10"}).err,
            "--need: kN is along a line; --lever says how far from the axis that is\n");
  EXPECT_EQ(mor(place, {"--need", "200@10V"}).err,
            "--need: \"V\" is not one of rad/s, deg/s, rev/s, rpm; with --lever m/s, mm/s too\n");
  EXPECT_EQ(mor(place, {"--lever", "0.1"}).exit_code, 2);
  const Outcome unused = mor(place, {"--need", "100@5", "--lever", "0.1"});
  EXPECT_EQ(unused.exit_code, 2);
  EXPECT_NE(unused.err.find("--lever: is of forces and speeds along a line"), std::string::npos)
      << unused.err;
}

// What rounding left beside 3360 W and 253.75 rad/s, on both sides of a corner.
TEST(MorOptions, TablesHaveTheDigitsThatAreKnown) {
  const Workplace place;
  const std::string table = mor(place, {"--table", "--side", "motor"}).out;
  EXPECT_NE(table.find("\n-253.75,16,16,50,50,-3360,-3360,voltage,current\n"), std::string::npos)
      << table;
  EXPECT_NE(table.find("\n-210,0,16,0,50,0,-2660,voltage,current\n"), std::string::npos) << table;
  for (const char* noise : {"99999", "00000", "e-1"}) {
    EXPECT_EQ(table.find(noise), std::string::npos) << noise << table;
  }
}

TEST(MorOptions, JsonIsWhatANameThatEndsSoHolds) {
  const Workplace place;
  for (std::vector<std::string> options : std::vector<std::vector<std::string>>{
           {}, {"--need", "200@10"}, {"--ratio", "4:40"}, {"--format", "mujoco"}}) {
    const bool is_need = !options.empty() && options[0] == "--need";
    std::vector<std::string> as_json = options;
    as_json.push_back("--json");
    options.insert(options.end(), {"-o", "x.json"});
    EXPECT_EQ(mor(place, options).exit_code, is_need ? 1 : 0);
    EXPECT_EQ(place.files().at("x.json"), mor(place, as_json).out);
  }
}

// Oracle: 1536 (1 - 10 / 10.5) = 73.14 Nm of the knee's line, so that 126.9 of 200 are missing.
TEST(MorOptions, ANeedIsAnsweredAndDrawn) {
  const Workplace place;
  const Outcome drawn = mor(place, {"--need", "200@10", "--plot", "x.svg"});
  if (drawn.err.find("not installed") != std::string::npos) GTEST_SKIP() << "no gnuplot";
  EXPECT_EQ(drawn.exit_code, 1) << drawn.err;
  EXPECT_EQ(drawn.out, mor(place, {"--need", "200@10"}).out);
  const std::string picture = place.text("x.svg");
  EXPECT_NE(picture.find("needed: 200 Nm at 10 rad/s, 126.9 Nm missing"), std::string::npos);
  for (const char* title :
       {"<title>knee D151: motor operating region at the joint</title>",
        "<title>torques that are there</title>", "<title>limited by voltage</title>"}) {
    EXPECT_NE(picture.find(title), std::string::npos) << title;
  }
  EXPECT_EQ(picture.find("<title>gnuplot"), std::string::npos);
  EXPECT_EQ(mor(place, {"--need", "100@5", "--plot", "y.svg"}).exit_code, 0);
  EXPECT_NE(place.text("y.svg").find("needed: 100 Nm at 5 rad/s, margin 220 Nm"),
            std::string::npos);
}

TEST(MorOptions, APictureAndRowsAreMadeTogether) {
  const Workplace place;
  const Outcome alone = mor(place, {"--plot", "x.svg"});
  if (alone.err.find("not installed") != std::string::npos) GTEST_SKIP() << "no gnuplot";
  EXPECT_EQ(alone.out, "");
  const Outcome both = mor(place, {"--plot", "y.svg", "--at-speed", "0,5"});
  EXPECT_EQ(both.out, mor(place, {"--at-speed", "0,5"}).out);
  EXPECT_EQ(place.files().at("y.svg"), place.files().at("x.svg"));
}

// Of a curve from half full on, nobody knows what a fifth is.
TEST(MorOptions, AChargeOutsideOfTheBatterysCurveIsRefused) {
  const Workplace place;
  std::string text = text_of(kKnee);
  text.insert(text.rfind('}'), R"(, "battery": {"series_cells": 16, "parallel_cells": 1,
    "cell_resistance_ohm": 0.01, "cell_open_circuit_V": [{"state_of_charge": 0.5, "voltage_V": 3.7},
                            {"state_of_charge": 1, "voltage_V": 4.2}]})");
  place.write("knee.json", text);
  const auto at = [&](const char* charge) {
    return place.run(
        {"actuator", "mor", "knee.json", "--state-of-charge", charge, "--at-speed", "0"});
  };
  EXPECT_EQ(at("0.5").exit_code, 0) << at("0.5").err;
  const Outcome outcome = at("0.2");
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(
      outcome.err,
      "knee.json: a state of charge of 0.2 lies outside of the battery's curve, which is known "
      "from 0.5 to 1 (/battery/cell_open_circuit_V)\n");
}

TEST(MorOptions, ADrawingIsAnSvgOrNothing) {
  Workplace place;
  place.write("knee.json", knee());
  const Outcome outcome = place.run({"gearbox", "optimize", "knee.json", "--draw", "x.png"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.err, "--draw: \"x.png\" must end with .svg\n");
  EXPECT_FALSE(place.files().contains("x.png"));
}

}  // namespace
}  // namespace torquewright::cli_test
