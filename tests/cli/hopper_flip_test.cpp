// SPDX-License-Identifier: Apache-2.0
// `hopper flip` as users start it: options, refusals, files and exit codes. What it plans is tested
// where plan_motion() is.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "io/documents/document.hpp"
#include "tests/cli/shell_words.hpp"
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
  for (const char* weight : {"0", "-1", "0.9e-6", "1.1e6", "1e300"}) {
    expect_refusal({"--objective", std::string("height=") + weight}, "WEIGHT is from 1e-6 to 1e6");
  }
  for (const char* weight : {"", "2x", "inf", "nan"}) {
    expect_refusal({"--objective", std::string("height=") + weight}, "WEIGHT is a number");
  }
  expect_refusal({"--objective", "height=1", "--objective", "height=2"}, "stands twice");
}

TEST_F(HopperFlip, RefusesDistancesThatItsTaskDoesNotHave) {
  expect_refusal({"--rise", "0.2"}, "a flip rises as far as it has to");
  expect_refusal({"--stride", "0.2"}, "only --task hop takes it");
  expect_refusal({"--task", "jump", "--stride", "0.2"}, "only --task hop takes it");
  expect_refusal({"--task", "jump", "--rise", "-0.1"}, "--rise");
  expect_refusal({"--task", "jump", "--speed", "0.2"}, "--speed: only --task hop takes it");
  expect_refusal({"--task", "jump", "--land-at", "0.1"}, "--land-at: only --task hop takes it");
  expect_refusal({"--repeat", "2"}, "comes down from a single turn");
  expect_refusal({"--task", "hop", "--repeat", "13"}, "--repeat");
  expect_refusal({"--task", "hop", "--repeat", "2", "--contacts", "flat,flight,flat"},
                 "both say how often it flies");
  expect_refusal({"--task", "hop", "--speed", "0"}, "goes nowhere");
  expect_refusal({"--task", "hop", "--speed", "9"}, "--speed");
  expect_refusal({"--task", "hop", "--speed", "-0.5", "--stride", "0.2"},
                 "does not go where a --stride of 0.2 m goes");
  expect_refusal({"--task", "hop", "--land-at", "2"}, "--land-at");
  expect_refusal({"--task", "hop", "--repeat", "1", "--alike"}, "--alike: is of hops that follow");
  expect_refusal({"--task", "hop", "--land-at", "0.085"}, "a --stride of 0.27 m or more");
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

// Oracle: the parabola; 1 m of rise takes sqrt(2/g) = 0.452 s up alone.
TEST_F(HopperFlip, RefusesPhasesThatNothingFitsInto) {
  expect_refusal({"--longest-first", "0.1"}, "--longest-first");
  expect_refusal({"--longest-last", "nan"}, "--longest-last");
  expect_refusal({"--task", "jump", "--rise", "1", "--longest-flight", "0.3"},
                 "--longest-flight: is 0.3 s, and this phase takes 0.452 s at least");
}

TEST_F(HopperFlip, RefusesAReserveBeyondWhatThereIs) {
  expect_refusal(
      {"--reserve", "0.2"},
      "0.2 would keep 0.75 of centre of pressure (--center-of-pressure-margin), and 0.49 "
      "is the most");
  expect_refusal({"--reserve", "-0.01"}, "--reserve");
  // The ankle's range is 1.571 rad.
  expect_refusal({"--position-margin", "0.8"}, "leave nothing of joint 'ankle_pitch'");
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

// What a motion to begin from decides is not asked for besides.
TEST_F(HopperFlip, RefusesWhatAMotionToBeginFromLeavesWithoutEffect) {
  const std::string hop = "specs/trajectory/hopper_hop.csv";
  expect_refusal({"--warm", hop, "--guess-noise", "0.1"}, "--warm begins from a motion");
  const json contacts = json::parse(place_.text("specs/robot/hopper.json"))["contacts"];
  std::istringstream lines(place_.text(hop));
  std::string flagged;
  bool is_header = true;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("#")) continue;
    for (const json& contact : contacts) {
      line += is_header ? "," + contact["name"].get<std::string>() + "_contact" : ",1";
    }
    is_header = false;
    flagged += line + "\n";
  }
  place_.write("flagged.csv", flagged);
  for (const char* option : {"--contact-height", "--contact-speed"}) {
    expect_refusal({"--warm", "flagged.csv", option, "0.01"}, "has columns for contacts");
  }
}

TEST_F(HopperFlip, RefusesRobotsThatHaveNoPlaneOrNoWayBackDown) {
  expect_refusal({}, "no contact points", "specs/robot/cassie.json");
  expect_refusal({"--contacts", "flat,hee,flat"}, "'hee'");
  // Standing still would keep every rule of these.
  for (const char* task : {"flip", "jump", "hop"}) {
    expect_refusal({"--task", task, "--contacts", "flat"}, "never leaves the ground");
    expect_refusal({"--task", task, "--contacts", "flat,toe,flat"}, "'flight' among its contacts");
  }
  expect_refusal({"--contacts", "flat,flight"}, "'flat'");
  const std::string robot = robot_with("/mechanisms/1/rods/0/rod_length_m", 0.16);
  expect_refusal({}, "symmetric", robot);
}

TEST_F(HopperFlip, RefusesConditionsThatTheDocumentsDoNotKnow) {
  expect_refusal({"--bus-voltage", "60", "--state-of-charge", "0.5"}, "one sets the other");
}

// Oracle: /bin/sh takes the lines apart into words, with which the program then checks the plan.
TEST_F(HopperFlip, NextLinesAreWhatAShellTakes) {
  const std::string robot = "specs/robot/" + kAwkwardName, motion = "plan " + kAwkwardName + ".csv";
  place_.write(robot, place_.text("specs/robot/hopper.json"));
  const Outcome planned = place_.run({"hopper", "flip", robot, "-o", motion, "--task", "jump",
                                      "--intervals", "20", "--bus-voltage", "60"});
  ASSERT_EQ(planned.exit_code, 0) << planned.err;
  for (const std::string verb : {"check", "replay"}) {
    const auto words = suggested_words(planned.out, "next: torquewright hopper " + verb);
    EXPECT_EQ(words, (Words{robot, motion, "--bus-voltage", "60"})) << planned.out;
  }
  const auto words = suggested_words(planned.out, "next: torquewright");
  EXPECT_EQ(place_.run(words).exit_code, 0);
}

// A jump on a coarse mesh: what is written is a plan by `hopper check`, told nothing more; twice
// the same bytes.
TEST_F(HopperFlip, WritesAMotionThatTheCheckPasses) {
  const Words jump{"--task",    "jump",      "--intervals",  "20",       "--bus-voltage",
                   "60",        "--json",    "--write-best", "best.csv", "--report",
                   "page.html", "--figures", "figures.svg"};
  const Outcome planned = run(jump);
  ASSERT_EQ(planned.exit_code, 0) << planned.err;
  EXPECT_EQ(planned.err, "");
  const json report = json::parse(planned.out);
  EXPECT_NO_THROW(io::check_document(report, "plan_report", "report", ""));
  EXPECT_EQ(report["status"], "planned");
  EXPECT_EQ(report["task"], "jump");
  EXPECT_EQ(report["options"]["intervals"], 20);
  EXPECT_EQ(report["options"]["bus_voltage_V"], 60.0);
  EXPECT_EQ(report["options"].size(), 2u) << report["options"];
  EXPECT_EQ(report["inputs"][0]["path"], "specs/robot/hopper.json");
  EXPECT_FALSE(place_.has("best.csv")) << "there is a plan";
  EXPECT_NE(place_.text("page.html").find(">planned</span>"), std::string::npos);
  EXPECT_TRUE(place_.text("figures.svg").ends_with("</svg>\n"));
  const Outcome checked =
      place_.run({"hopper", "check", "specs/robot/hopper.json", "plan.csv", "--bus-voltage", "60"});
  EXPECT_EQ(checked.exit_code, 0) << checked.out << checked.err;

  const auto files = place_.files();
  EXPECT_EQ(run(jump).out, planned.out);
  EXPECT_EQ(place_.files(), files);
}

// Phases of a search that was cut short do not meet. What it has found is read as a motion all the
// same: `hopper check` says what of physics it lacks, not that its rows are none.
TEST_F(HopperFlip, WritesWhatComesClosestSoThatTheCheckReadsIt) {
  const Outcome outcome =
      run({"--iterations", "3", "--rounds", "0", "--intervals", "20", "--write-best", "best.csv"});
  ASSERT_EQ(outcome.exit_code, 3) << outcome.err;
  ASSERT_TRUE(place_.has("best.csv"));
  const Outcome checked = place_.run({"hopper", "check", "specs/robot/hopper.json", "best.csv"});
  EXPECT_EQ(checked.err.find("time repeats"), std::string::npos) << checked.err;
  EXPECT_NE(checked.err.find("is not the rate of its velocity"), std::string::npos) << checked.err;
}

// What ended early is no plan: exit code 3, and no motion that could be taken for one.
TEST_F(HopperFlip, EndsOnCtrlCWithoutAMotion) {
  place_.here.interrupt_after = std::chrono::milliseconds(200);
  const Outcome outcome = run({"--json", "--plot-momentum", "momentum.svg"});
  if (outcome.err.find("not installed") != std::string::npos) GTEST_SKIP() << "no gnuplot";
  ASSERT_EQ(outcome.exit_code, 3) << outcome.err;
  const json report = json::parse(outcome.out);
  EXPECT_NO_THROW(io::check_document(report, "plan_report", "report", ""));
  EXPECT_EQ(report["status"], "limit");
  EXPECT_NE(report["reason"], "");
  EXPECT_FALSE(place_.has("plan.csv"));
  EXPECT_FALSE(place_.has("momentum.svg"));
  EXPECT_NE(outcome.err.find("plan.csv: not written, there is no plan"), std::string::npos);
  EXPECT_NE(outcome.err.find("momentum.svg: not written"), std::string::npos);
}

// Ten milliseconds are no time: whatever there is by then is no plan either.
TEST_F(HopperFlip, EndsAtItsTimeLimit) {
  const Outcome outcome = run({"--time-limit", "0.01"});
  EXPECT_EQ(outcome.exit_code, 3) << outcome.out;
  EXPECT_TRUE(outcome.out.starts_with("limit: ")) << outcome.out;
  EXPECT_NE(outcome.out.find("\nnext: --time-limit 0.02 "), std::string::npos) << outcome.out;
  EXPECT_FALSE(place_.has("plan.csv"));
}

}  // namespace
}  // namespace torquewright::cli_test
