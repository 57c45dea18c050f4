// SPDX-License-Identifier: Apache-2.0
// `hopper replay` as users start it: how motions end in either engine, trials, and refusals.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "io/documents/document.hpp"
#include "tests/cli/workplace.hpp"

namespace torquewright::cli_test {
namespace {

using nlohmann::json;
using Words = std::vector<std::string>;

constexpr double kDegree = 0.017453292519943295;

class HopperReplay : public testing::Test {
 protected:
  HopperReplay() {
    fs::copy(in_repository("specs"), place_.path("specs"), fs::copy_options::recursive);
  }

  Outcome run(const Words& options, const std::string& motion = "squat",
              const std::string& command = "replay") const {
    Words words{"hopper", command, "specs/robot/hopper.json",
                "specs/trajectory/hopper_" + motion + ".csv"};
    words.insert(words.end(), options.begin(), options.end());
    return place_.run(words);
  }
  json report(Words options, const std::string& motion = "squat") const {
    options.push_back("--json");
    const Outcome outcome = run(options, motion);
    EXPECT_EQ(outcome.err, "");
    const json report = json::parse(outcome.out);
    EXPECT_NO_THROW(io::check_document(report, "replay_report", "report", ""));
    const bool is_open = report["verdict"] == "unfinished" || report["verdict"] == "undecided";
    const auto code = report["verdict"] == "stands" ? 0 : is_open ? 3 : 1;
    if (!report.contains("trials")) {
      EXPECT_EQ(outcome.exit_code, code);
    }
    return report;
  }
  static json finding(const json& report, const std::string& rule, const std::string& joint) {
    for (const json& one : report["findings"]) {
      if (one["rule"] == rule && one["joint"] == joint) return one;
    }
    ADD_FAILURE() << "no finding " << rule << " of " << joint;
    return {{"time_s", 0.0}};
  }
  void expect_refusal(const Words& options, const std::string& sentence,
                      const std::string& motion = "squat") const {
    const Outcome outcome = run(options, motion);
    EXPECT_EQ(outcome.exit_code, 2) << outcome.out;
    EXPECT_NE(outcome.err.find(sentence), std::string::npos) << outcome.err;
    EXPECT_EQ(outcome.out, "");
  }

  Workplace place_;
};

// Oracle: `hopper check`, whose inverse dynamics knows no time step, no controller and no contact
// but the motion's own. The squat is slow: what feedback adds is small beside gravity.
TEST_F(HopperReplay, ASquatStandsInBothEnginesAtTheTorquesOfTheCheck) {
  const json check = json::parse(run({"--json"}, "squat", "check").out);
  for (const char* engine : {"own", "mujoco"}) {
    for (const char* controller : {"lqr", "pd", "osc"}) {
      const json replayed = report({"--engine", engine, "--controller", controller});
      EXPECT_EQ(replayed["verdict"], "stands") << replayed["end"];
      EXPECT_EQ(replayed["engine"], engine);
      EXPECT_EQ(replayed["touch_down"], nullptr);
      for (std::size_t i = 0; i < 3; ++i) {
        const json& drive = replayed["joints"][i];
        EXPECT_EQ(drive["clipped_share"], 0.0);
        const double peak_Nm = check["joints"][i]["peak_torque_Nm"];
        EXPECT_NEAR(drive["peak_torque_Nm"].get<double>(), peak_Nm, 0.02 * peak_Nm + 0.1);
        const double load_Nm = check["transmission_load"][i]["joint_Nm"];
        const double passes_Nm = replayed["transmission_load"][i]["joint_Nm"];
        EXPECT_NEAR(passes_Nm, load_Nm, 0.02 * load_Nm + 0.1);
      }
    }
  }
}

// A document's tasks are told one by one, and no torque is asked for that a drive cannot give: also
// where the bus has too little voltage for the hop, whose torques another controller is cut from.
TEST_F(HopperReplay, TasksAreWeighedWithinTheDrivesRegions) {
  const Words tasks{"--controller", "osc", "--tasks", "specs/controller/hopper.json"};
  const json stood = report(tasks);
  EXPECT_EQ(stood["verdict"], "stands") << stood["end"];
  ASSERT_EQ(stood["tasks"]["tasks"].size(), 5u);
  EXPECT_EQ(stood["tasks"]["tasks"][0]["task"], "center_of_mass, stance");
  EXPECT_EQ(stood["tasks"]["unsolved"], 0);
  EXPECT_GT(stood["tasks"]["looks"].get<int>(), 1000);
  const auto cut_Nm = [](const json& replayed) {
    double most_Nm = 0.0;
    for (const json& drive : replayed["joints"]) {
      most_Nm = std::max(most_Nm, drive["peak_cut_off_Nm"].get<double>());
    }
    return most_Nm;
  };
  Words low = tasks;
  low.insert(low.end(), {"--bus-voltage", "20"});
  const double other_Nm = cut_Nm(report({"--controller", "pd", "--bus-voltage", "20"}, "hop"));
  EXPECT_GT(other_Nm, 10.0);
  // Voltage and speed go on changing for half a millisecond after the look.
  EXPECT_LT(cut_Nm(report(low, "hop")), 0.1 * other_Nm);
}

// Oracles: `hopper check`, by which the knee is farthest outside its region at take-off, at t =
// 0.612 s; and the other engine, whose contact is made another way.
TEST_F(HopperReplay, TheHandMadeFlipFallsUnderRegionAndBoxInBothEngines) {
  for (const char* limits : {"mor", "box"}) {
    const json own = report({"--limits", limits}, "flip");
    const json mujoco = report({"--limits", limits, "--engine", "mujoco"}, "flip");
    for (const json& replayed : {own, mujoco}) {
      EXPECT_EQ(replayed["verdict"], "fell");
      EXPECT_EQ(replayed["limits"], limits);
      EXPECT_GT(replayed["joints"][0]["clipped_share"].get<double>(), 0.01);
      const json& clipped = finding(replayed, "clipped", "knee");
      EXPECT_NEAR(clipped["time_s"].get<double>(), 0.612, 0.05);
      EXPECT_GT(replayed["touch_down"]["rotation_short_rad"].get<double>(), 2 * kDegree);
    }
    EXPECT_NEAR(own["touch_down"]["rotation_short_rad"].get<double>(),
                mujoco["touch_down"]["rotation_short_rad"].get<double>(), 5 * kDegree);
    EXPECT_NEAR(own["bus"]["least_V"].get<double>(), mujoco["bus"]["least_V"].get<double>(), 0.5);
  }
}

/// A column's first two numbers.
std::array<double, 2> two_of(const std::string& table, const std::string& column) {
  std::istringstream lines(table);
  const auto cells = [&] {
    std::string line, cell;
    std::getline(lines, line);
    std::istringstream in_line(line);
    std::vector<std::string> all;
    while (std::getline(in_line, cell, ',')) all.push_back(cell);
    return all;
  };
  const std::vector<std::string> header = cells();
  const auto at = std::find(header.begin(), header.end(), column) - header.begin();
  const auto place = static_cast<std::size_t>(at);
  const double first = std::stod(cells().at(place));
  return {first, std::stod(cells().at(place))};
}

// Oracle: what was wanted is what acted and what was cut off. There the knee turns faster than its
// region reaches: what was wanted does not act, at the first row either.
TEST_F(HopperReplay, WhatActsAtTheFirstRowIsNotWhatWasWanted) {
  const json replayed = report({"--from", "0.612", "--until", "0.72", "--stand", "0",
                                "--controller", "pd", "--series", "run.csv"},
                               "flip");
  const std::string series = place_.text("run.csv");
  const auto wanted_Nm = two_of(series, "knee_drive_wanted_torque_Nm");
  const auto made_Nm = two_of(series, "knee_drive_torque_Nm");
  const auto cut_off_Nm = two_of(series, "knee_drive_cut_off_torque_Nm");
  EXPECT_NEAR(made_Nm[0] + cut_off_Nm[1], wanted_Nm[0], 1e-9 * std::abs(wanted_Nm[0]));
  EXPECT_GT(std::abs(cut_off_Nm[1]), 100.0);
  EXPECT_LT(replayed["joints"][0]["peak_torque_Nm"].get<double>(), std::abs(wanted_Nm[0]));
}

// Oracle: the other engine. The hop lies inside the regions by `hopper check`; it lands in both
// within two control periods of each other, and of the plan within these and the time in which it
// falls by the 2 mm by which a regulator may set its sole down unevenly, after a flight of 140 ms.
// With the foot 1.4 degrees toe down the same fall ended 2 ms sooner.
TEST_F(HopperReplay, AHopInsideTheRegionsStandsInBothEngines) {
  EXPECT_EQ(run({}, "hop", "check").exit_code, 0);
  const json own = report({}, "hop");
  const json mujoco = report({"--engine", "mujoco"}, "hop");
  const double late_s = 1e-3 + 2e-3 / (9.81 * 70e-3);
  for (const json& replayed : {own, mujoco}) {
    EXPECT_EQ(replayed["verdict"], "stands") << replayed["end"];
    EXPECT_NEAR(replayed["touch_down"]["time_s"].get<double>(),
                replayed["touch_down"]["planned_s"].get<double>(), late_s);
    EXPECT_NEAR(replayed["touch_down"]["rotation_short_rad"].get<double>(), 0.0, kDegree);
  }
  EXPECT_NEAR(own["touch_down"]["time_s"].get<double>(),
              mujoco["touch_down"]["time_s"].get<double>(), 1e-3);
}

// Oracle: speeds without load. At 4 V of 67.2 the knee turns by 0.63 rad/s at most and the ankle by
// 1.14 rad/s, at levers of 0.35 and 0.1 m: 0.33 m/s at take-off, a flight of 68 ms. The hop's lasts
// 140 ms. The robot stands all the time.
TEST_F(HopperReplay, AHopThatFourVoltsCannotMakeIsMissedThoughItStands) {
  for (const char* engine : {"own", "mujoco"}) {
    const json replayed = report({"--bus-voltage", "4", "--engine", engine}, "hop");
    EXPECT_EQ(replayed["verdict"], "missed") << engine;
    EXPECT_GT(replayed["end"]["foot_at_rest_s"].get<double>(), 1.0);
    for (const json& deed : replayed["deeds"]) {
      const bool is_of_hop = deed["deed"] == "flight" || deed["deed"] == "rise" ||
                             deed["deed"] == "landing" || deed["deed"] == "last_place";
      EXPECT_EQ(deed["is_done"].get<bool>(), !is_of_hop) << deed;
    }
  }
}

TEST_F(HopperReplay, TolerancesOfWhatWasDoneCanBeSet) {
  EXPECT_EQ(report({}, "hop")["verdict"], "stands");
  const json strict = report({"--flight-tolerance", "0.01"}, "hop");
  EXPECT_EQ(strict["verdict"], "missed");
  EXPECT_EQ(strict["options"]["flight_tolerance"], 0.01);
  expect_refusal({"--flight-tolerance", "0.6"}, "--flight-tolerance", "hop");
}

// Oracle: a cause that is alone has the trials of the document that states it alone, which draw
// the same numbers.
TEST_F(HopperReplay, ExplainsWhichCauseTrialsDoNotBear) {
  const std::string shifts =
      R"("center_of_mass_shift_m": [{"bodies": ["thigh"], "least": -0.03, "greatest": 0.03}])";
  const std::string head = R"({"kind": "randomisation", "version": 1, )";
  place_.write("both.json",
               head + shifts + R"(, "total_mass_factor": {"least": 0.9, "greatest": 1.1}})");
  place_.write("one.json", head + shifts + "}");
  const Words trials{"--trials", "4", "--seed", "3", "--randomise"};
  const auto with = [&](const std::string& file, bool explains) {
    Words options = trials;
    options.push_back(file);
    if (explains) options.push_back("--explain");
    return report(options, "hop")["trials"];
  };
  const json both = with("both.json", true);
  ASSERT_EQ(both["causes"].size(), 2u);
  EXPECT_EQ(both["causes"][1]["cause"], "center_of_mass_shift_m");
  const json one = with("one.json", false);
  EXPECT_EQ(both["causes"][1]["succeeded"], one["succeeded"]);
  double mean_rad = 0.0;
  for (const json& trial : one["list"]) mean_rad += trial["rotation_short_rad"].get<double>() / 4.0;
  EXPECT_NEAR(both["causes"][1]["rotation_short_rad"].get<double>(), mean_rad, 1e-12);
  expect_refusal({"--trials", "4", "--randomise", "both.json", "--explain", "--trial", "1"},
                 "--explain", "hop");
  expect_refusal({"--trials", "4", "--randomise", "both.json", "--no-filter"},
                 "states no sensor_noise", "hop");
}

TEST_F(HopperReplay, RefusesARobotThatCannotFall) {
  place_.write("specs/robot/arm.json", R"({"kind": "robot", "version": 1, "name": "arm",
    "base": {"body": "wall", "motion": "fixed"},
    "bodies": [{"name": "wall"}, {"name": "arm", "mass_kg": 1, "center_of_mass_m": [0.5, 0, 0],
      "inertia_kg_m2": {"xx": 0.1, "yy": 0.1, "zz": 0.1}}],
    "joints": [{"name": "elbow", "type": "revolute", "parent": "wall", "child": "arm",
      "axis": [0, 1, 0]}],
    "mechanisms": [{"type": "direct", "joints": ["elbow"],
      "actuators": ["../actuator/d151_knee.json"]}]})");
  std::string motion = "time_s,elbow_position_rad\n";
  for (int i = 0; i <= 100; ++i) motion += std::to_string(0.01 * i) + ",0\n";
  place_.write("arm.csv", motion);
  const Outcome outcome = place_.run({"hopper", "replay", "specs/robot/arm.json", "arm.csv"});
  EXPECT_EQ(outcome.exit_code, 2) << outcome.out;
  EXPECT_NE(outcome.err.find("a replay tells whether a robot stands or falls"), std::string::npos)
      << outcome.err;
}

TEST_F(HopperReplay, WhatItWritesByTimeIsAMotionThatTheCheckPasses) {
  const Outcome replayed = run({"--series", "run.csv", "-o", "run.txt"});
  ASSERT_EQ(replayed.exit_code, 0) << replayed.err;
  EXPECT_EQ(replayed.out, "");
  EXPECT_EQ(place_.text("run.txt").find("specs/trajectory/hopper_squat.csv: stands"), 0u);
  const Outcome checked =
      place_.run({"hopper", "check", "specs/robot/hopper.json", "run.csv", "--until", "1.4"});
  EXPECT_EQ(checked.exit_code, 0) << checked.out << checked.err;
}

// Oracle: the closed form of Wilson's interval for n of n, n / (n + z^2) to 1.
TEST_F(HopperReplay, TrialsPrintARateWithItsIntervalTheSameForAnyNumberOfThreads) {
  json calm = json::parse(place_.text("specs/randomisation/hopper.json"));
  calm.erase("sensor_noise");
  place_.write("specs/randomisation/calm.json", calm.dump());
  const Words options{"--stand",  "0.2", "--step",      "0.0005",
                      "--trials", "6",   "--randomise", "specs/randomisation/calm.json"};
  const auto with_threads = [&](const char* threads) {
    Words words = options;
    words.insert(words.end(), {"--threads", threads, "--json"});
    return run(words);
  };
  const Outcome one = with_threads("1");
  EXPECT_EQ(one.out, with_threads("3").out);
  const json report = json::parse(one.out);
  EXPECT_NO_THROW(io::check_document(report, "replay_report", "report", ""));
  const json& trials = report["trials"];
  EXPECT_EQ(trials["count"], 6);
  EXPECT_EQ(trials["succeeded"], 6);
  EXPECT_EQ(one.exit_code, 0);
  constexpr double kZ = 1.959963984540054;
  EXPECT_NEAR(trials["interval"][0].get<double>(), 6.0 / (6.0 + kZ * kZ), 1e-9);
  EXPECT_NEAR(trials["interval"][1].get<double>(), 1.0, 1e-12);

  Words alone = options;
  alone.insert(alone.end(), {"--trial", "4", "--json"});
  const json fourth = json::parse(run(alone).out);
  ASSERT_EQ(fourth["trials"]["list"].size(), 1u);
  EXPECT_EQ(fourth["trials"]["list"][0], trials["list"][4]);
}

// What cannot stand: the ground is there 1 m late.
TEST_F(HopperReplay, ARateThatIsMissedFails) {
  place_.write("deep.json",
               R"({"kind": "randomisation", "version": 1, "name": "deep",
                   "ground_height_m": {"least": -1, "greatest": -0.9}})");
  const Words options{"--trials", "2", "--randomise", "deep.json", "--stand", "0.2"};
  EXPECT_EQ(run(options).exit_code, 1);
  Words lenient = options;
  lenient.insert(lenient.end(), {"--success-rate", "0"});
  EXPECT_EQ(run(lenient).exit_code, 0);
  // Oracle: the time at which the trial's own row says that it ended.
  Words alone = options;
  alone.insert(alone.end(), {"--trial", "1", "--series", "deep.csv", "--json"});
  const json second = json::parse(run(alone).out);
  const std::string rows = place_.text("deep.csv");
  const std::string last = rows.substr(rows.rfind('\n', rows.size() - 2) + 1);
  EXPECT_NEAR(std::stod(last), second["trials"]["list"][0]["end_s"].get<double>(), 1e-3);
  EXPECT_GT(second["end"]["time_s"].get<double>(), std::stod(last) + 0.1);  // As documented.
}

TEST_F(HopperReplay, CtrlCInTrialsLeavesWhatIsDone) {
  place_.write("close.json", R"({"kind": "randomisation", "version": 1, "name": "close",
    "friction_coefficient": {"least": 0.59, "greatest": 0.6}})");
  place_.here.interrupt_after = std::chrono::milliseconds(1500);
  const Outcome outcome = run({"--trials", "100000", "--randomise", "close.json", "--json"});
  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_EQ(outcome.err, "");
  const json trials = json::parse(outcome.out)["trials"];
  EXPECT_LT(trials["count"].get<int>(), 100000);
  EXPECT_EQ(trials["count"].get<int>() + trials["unfinished"].get<int>(), 100000);
}

TEST_F(HopperReplay, ASweepOfTheStepShowsWhatDependsOnIt) {
  const json swept = report({"--from", "0.75", "--stand", "0.2", "--sweep-step"}, "flip");
  ASSERT_GE(swept["step_sweep"].size(), 3u);
  // Oracle: the momentum that the landing takes is the step's to within its order; the force is
  // not. All steps land within a control period.
  const json& first = swept["step_sweep"].front();
  for (const json& one : swept["step_sweep"]) {
    EXPECT_NEAR(one["touch_down"]["time_s"].get<double>(),
                first["touch_down"]["time_s"].get<double>(), 6e-4);
    EXPECT_NEAR(one["touch_down_load"]["impulse_N_s"][2].get<double>(),
                first["touch_down_load"]["impulse_N_s"][2].get<double>(), 1.0);
  }
}

TEST_F(HopperReplay, ABatteryThatCannotGiveThePowerIsSaid) {
  place_.write("specs/robot/hopper.json",
               with(place_.text("specs/robot/hopper.json"), "\"cell_resistance_ohm\": 0.015",
                    "\"cell_resistance_ohm\": 0.5"));
  const Outcome outcome = run({"--json"}, "flip");
  EXPECT_EQ(outcome.exit_code, 1) << outcome.err;
  EXPECT_EQ(outcome.out.find("nan"), std::string::npos);
  EXPECT_NE(outcome.out.find("battery-power"), std::string::npos);
}

TEST_F(HopperReplay, OfNoTimeIsRefused) {
  const Outcome outcome = run({"--until", "0", "--stand", "0", "--series", "s.csv"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_TRUE(outcome.err.starts_with("--stand: the motion and 0 s of standing last 0 s"))
      << outcome.err;
  EXPECT_FALSE(place_.has("s.csv"));
}

TEST_F(HopperReplay, AControllerThatIsTooLateEndsWithTimeAndReason) {
  const json late = report({"--latency", "0.05"}, "flip");
  EXPECT_NE(late["verdict"], "stands");
  EXPECT_NE(late["end"]["reason"], "");
  EXPECT_GT(late["end"]["time_s"].get<double>(), 0.0);
}

TEST_F(HopperReplay, RefusesByName) {
  expect_refusal({"--ground-rise", "0.01"}, "is 0.01 m below the ground");
  expect_refusal({"--tasks", "specs/controller/hopper.json"}, "belongs with --controller osc");
  place_.write(
      "other.json",
      R"({"kind": "controller", "version": 1, "robot": "Cassie", "tasks": [{"task": "joint"}]})");
  expect_refusal({"--controller", "osc", "--tasks", "other.json"},
                 "other.json#/robot: is for \"Cassie\", and the robot is \"one-legged hopper\"");
  expect_refusal({"--controller", "osc", "--impact", "invariant", "--impact-metric", "inertia"},
                 "--impact-metric: is euclidean with --controller osc");
  expect_refusal({"--trials", "3"}, "needs --randomise");
  place_.write("none.json", R"({"kind": "randomisation", "version": 1,
    "friction_coefficient": {"least": 0.6, "greatest": 0.6}})");
  expect_refusal({"--trials", "3", "--randomise", "none.json"}, "none.json: varies nothing");
  expect_refusal({"--step", "0.001"}, "longer than the control period");
  expect_refusal(
      {"--trials", "3", "--randomise", "specs/randomisation/hopper.json", "--trial", "3"},
      "3 is not one of the trials 0 to 2");
  expect_refusal({"--impact", "invariant", "--control-period", "0.06", "--step", "0.001"},
                 "--impact-window");
  expect_refusal({"-o", "specs/trajectory/hopper_squat.csv"}, "hopper_squat.csv");
  // Ten thousand seconds between two rows of ten: 9e8 steps, and no memory for them.
  std::string slow;
  std::istringstream lines(place_.text("specs/trajectory/hopper_squat.csv"));
  int row = -1;
  for (std::string line; std::getline(lines, line) && row < 10;) {
    if (line.starts_with("#")) continue;
    const std::string rest = line.substr(line.find(','));
    slow += (row < 0 ? "time_s" : std::to_string(row) + "e4") + rest + "\n";
    ++row;
  }
  place_.write("slow.csv", slow);
  const Outcome long_one = place_.run({"hopper", "replay", "specs/robot/hopper.json", "slow.csv"});
  EXPECT_EQ(long_one.exit_code, 2);
  EXPECT_NE(long_one.err.find("9e+08 steps of 0.0001 s, where a replay takes at most 1e+06"),
            std::string::npos)
      << long_one.err;
  // What would change nothing.
  expect_refusal({"--threads", "2"}, "--trials");
  for (const char* impact : {"default", "no_derivative"}) {
    expect_refusal({"--impact", impact, "--impact-metric", "inertia"}, "belongs with --impact inv");
    expect_refusal({"--impact", impact, "--impact-contact", "foot"}, "belongs with --impact inv");
  }
  expect_refusal({"--impact-window", "0.1"}, "belongs with --impact no_derivative or invariant");
  expect_refusal({"--impact-blend", "0.1"}, "belongs with --impact no_derivative or invariant");
  const Outcome other = place_.run(
      {"hopper", "replay", "specs/robot/rabbit.json", "specs/trajectory/hopper_squat.csv"});
  EXPECT_EQ(other.exit_code, 2) << other.out;
  EXPECT_NE(other.err, "");
}

}  // namespace
}  // namespace torquewright::cli_test
