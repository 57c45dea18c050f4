// SPDX-License-Identifier: Apache-2.0
// `hopper flip` as users start it: options, refusals, files and exit codes. What it plans is tested
// where plan_motion() is.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "io/document.hpp"
#include "tests/cli/workplace.hpp"

namespace torquewright::cli_test {
namespace {

using nlohmann::json;
using Words = std::vector<std::string>;

class HopperFlip : public testing::Test {
 protected:
  HopperFlip() {
    fs::copy(in_repository("specs"), place_.path("specs"), fs::copy_options::recursive);
  }

  Outcome run(const Words& options, const std::string& robot = "specs/robot/hopper.json") const {
    Words words{"hopper", "flip", robot, "-o", "plan.csv"};
    words.insert(words.end(), options.begin(), options.end());
    return place_.run(words);
  }
  /// Exit code 2 with that sentence, and no file written.
  void expect_refusal(const Words& options, const std::string& sentence,
                      const std::string& robot = "specs/robot/hopper.json") const {
    const auto before = place_.files();
    const Outcome outcome = run(options, robot);
    EXPECT_EQ(outcome.exit_code, 2) << outcome.out;
    EXPECT_NE(outcome.err.find(sentence), std::string::npos) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(place_.files(), before);
  }
  /// A copy of the hopper with one place changed.
  std::string robot_with(const char* pointer, json value) const {
    json robot = json::parse(place_.text("specs/robot/hopper.json"));
    robot[json::json_pointer(pointer)] = std::move(value);
    place_.write("specs/robot/changed.json", robot.dump());
    return "specs/robot/changed.json";
  }

  Workplace place_;
};

TEST_F(HopperFlip, RefusesObjectivesThatThereAreNot) {
  expect_refusal({"--objective", "hight"}, "did you mean \"height\"?");
  expect_refusal({"--objective", "height=0"}, "WEIGHT is a number greater than 0");
  expect_refusal({"--objective", "height=-1"}, "WEIGHT is a number greater than 0");
  expect_refusal({"--objective", "height="}, "WEIGHT is a number greater than 0");
  expect_refusal({"--objective", "height=2x"}, "WEIGHT is a number greater than 0");
  expect_refusal({"--objective", "height=inf"}, "WEIGHT is a number greater than 0");
  expect_refusal({"--objective", "height=1", "--objective", "height=2"}, "stands twice");
}

TEST_F(HopperFlip, RefusesNumbersOutOfTheirRange) {
  expect_refusal({"--voltage-margin", "1"}, "--voltage-margin");
  expect_refusal({"--center-of-pressure-margin", "0.5"}, "--center-of-pressure-margin");
  expect_refusal({"--friction-margin", "-0.1"}, "--friction-margin");
  expect_refusal({"--intervals", "3"}, "--intervals");
  expect_refusal({"--time-limit", "0"}, "--time-limit");
  expect_refusal({"--sample-step", "1"}, "--sample-step");
  expect_refusal({"--guess-noise", "nan"}, "--guess-noise");
  expect_refusal({"--bus-voltage", "0"}, "--bus-voltage");
  expect_refusal({"--limits", "torque"}, "--limits");
  expect_refusal({"--task", "walk"}, "--task");
}

TEST_F(HopperFlip, RefusesOptionsThatWouldDoNothing) {
  expect_refusal({"--seed", "3"}, "--guess-noise");
  for (const char* option :
       {"--column", "--columns", "--from", "--until", "--contact-height", "--contact-speed"}) {
    expect_refusal({option, "1"}, "--warm");
  }
}

TEST_F(HopperFlip, RefusesFilesThatItCannotWriteAsAsked) {
  const Outcome nowhere = place_.run({"hopper", "flip", "specs/robot/hopper.json"});
  EXPECT_EQ(nowhere.exit_code, 2);
  EXPECT_NE(nowhere.err.find("--output"), std::string::npos) << nowhere.err;
  expect_refusal({"--write-best", "best.json"}, "which is a CSV");
  expect_refusal({"--write-best", "plan.csv"}, "plan.csv");
  expect_refusal({"--write-best", ""}, "--write-best");
  expect_refusal({"--figures", "figures.png"}, "must end with .svg");
  expect_refusal({"--plot-momentum", "momentum.pdf"}, "momentum.pdf");
  expect_refusal({"--report", "no_folder/page.html"}, "no_folder");
  expect_refusal({"--report", "specs/robot/hopper.json"}, "hopper.json");
  expect_refusal({"--report", "specs/actuator/d151_knee.json"}, "d151_knee.json");
  expect_refusal(
      {"--warm", "specs/trajectory/hopper_hop.csv", "--report", "specs/trajectory/hopper_hop.csv"},
      "hopper_hop.csv");
}

TEST_F(HopperFlip, RefusesAMotionToBeginFromThatIsNotThisRobots) {
  expect_refusal({"--warm", "missing.csv"}, "missing.csv");
  expect_refusal({"--warm", "specs/trajectory/hopper_flip.csv"}, "no column",
                 "specs/robot/rabbit.json");
  expect_refusal({"--warm", "specs/trajectory/hopper_hop.csv", "--column", "none=knee.position"},
                 "no column \"none\"");
}

TEST_F(HopperFlip, RefusesRobotsThatHaveNoPlaneOrNoWayBackDown) {
  expect_refusal({}, "no contact points", "specs/robot/cassie.json");
  expect_refusal({"--contacts", "flat,hee,flat"}, "'hee'");
  expect_refusal({"--contacts", "flat,flight"}, "'flat'");
  const std::string robot = robot_with("/mechanisms/1/rods/0/rod_length_m", 0.16);
  expect_refusal({}, "symmetric", robot);
}

TEST_F(HopperFlip, RefusesConditionsThatTheDocumentsDoNotKnow) {
  expect_refusal({"--bus-voltage", "60", "--state-of-charge", "0.5"}, "one sets the other");
}

}  // namespace
}  // namespace torquewright::cli_test
