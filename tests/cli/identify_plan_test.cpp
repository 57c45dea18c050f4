// SPDX-License-Identifier: Apache-2.0
// `identify plan` and `identify simulate` as a user runs them: what is planned can be played, what
// is played can be read, what cannot be done is refused.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "tests/cli/spoilt_log.hpp"
#include "tests/cli/workplace.hpp"

namespace torquewright::cli_test::plan {
namespace {

using nlohmann::json;
using Words = std::vector<std::string>;

std::string actuator() { return in_repository("specs/log/bench_actuator.json"); }
std::string rig() { return in_repository("specs/log/bench_rig.json"); }

Words plan_words(const Words& more) {
  Words words = {"identify",
                 "plan",
                 actuator(),
                 "--rig",
                 rig(),
                 "--separate",
                 "coulomb_friction,viscous_friction",
                 "--duration",
                 "8"};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

void expect_refused(const Workplace& place, const Words& words, const std::string& said) {
  const auto before = place.files();
  const Outcome outcome = place.run(words);
  EXPECT_EQ(outcome.exit_code, 2) << said;
  EXPECT_EQ(outcome.out, "") << said;
  EXPECT_NE(outcome.err.find(said), std::string::npos) << outcome.err;
  EXPECT_EQ(place.files(), before) << said;
}

// The loop of a user: plan, play on an actuator with 0.3 Nm of Coulomb friction, identify.
TEST(IdentifyPlan, WhatIsPlannedIsPlayedAndNamesTheEffect) {
  const Workplace place;
  const Outcome planned = place.run(plan_words({"-o", "plan.csv", "--json"}));
  ASSERT_EQ(planned.exit_code, 0) << planned.err;
  const json plan = json::parse(planned.out);
  EXPECT_EQ(plan["separable"], true);
  ASSERT_EQ(plan["parameters"].size(), 2u);
  for (const json& each : plan["parameters"]) {
    EXPECT_GT(each["plan"]["standard_error"].get<double>(), 0.0);
    EXPECT_LE(each["plan"]["separability"].get<double>(), 1.0);
  }
  const SpoiltLog excitation(place.text("plan.csv"));
  EXPECT_EQ(std::stod(excitation.rows.front()[1]), 0.0);
  json truth = json::parse(text_of(actuator()));
  truth["effects"] = {{{"effect", "coulomb_friction"},
                       {"parameters", {{"coulomb_Nm", 0.3}}},
                       {"provenance", "assumed"}}};
  place.write("truth.json", truth.dump());
  const Outcome played = place.run({"identify", "simulate", "truth.json", "--rig", rig(),
                                    "--excitation", "plan.csv", "--noise", "output_torque_Nm=0.1",
                                    "--noise", "output_position_rad=0.0002", "-o", "log.csv"});
  ASSERT_EQ(played.exit_code, 0) << played.err;
  EXPECT_EQ(played.out, "");
  const Outcome found =
      place.run({"identify", "log.csv", "--rig", rig(), "--actuator", actuator(), "--json"});
  const json report = json::parse(found.out);
  ASSERT_GE(report["effects_added"].size(), 1u) << found.out;
  const json& effect = report["effects_added"][0];
  EXPECT_EQ(effect["effect"], "coulomb_friction");
  EXPECT_NEAR(effect["parameters"]["coulomb_Nm"].get<double>(), 0.3, 0.03);
}

// Twice the noise of every channel, twice the error: the information is homogeneous in it. The
// excitation is the same, since no candidate changes its rank.
TEST(IdentifyPlan, ErrorsGrowWithTheNoiseThatIsStated) {
  const Workplace place;
  const auto error = [&](const Words& noise) {
    const json plan = json::parse(place.run(plan_words(noise)).out);
    return plan["parameters"][0]["plan"]["standard_error"].get<double>();
  };
  const Words once = {"--json",
                      "--noise",
                      "output_torque_Nm=0.1",
                      "--noise",
                      "motor_current_A=0.1",
                      "--noise",
                      "output_position_rad=0"};
  const Words twice = {"--json",
                       "--noise",
                       "output_torque_Nm=0.2",
                       "--noise",
                       "motor_current_A=0.2",
                       "--noise",
                       "output_position_rad=0"};
  EXPECT_NEAR(error(twice), 2.0 * error(once), 1e-9 * error(twice));
}

TEST(IdentifyPlan, OfAnExactIdentityIsUndecided) {
  const Workplace place;
  const Outcome outcome = place.run({"identify", "plan", actuator(), "--rig", rig(), "--separate",
                                     "torque_offset,asymmetric_friction", "--duration", "8"});
  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_NE(outcome.out.find("the same in the torque balance"), std::string::npos);
  EXPECT_NE(outcome.out.find("tare"), std::string::npos);
}

TEST(IdentifyPlan, RefusesWhatCannotBePlanned) {
  const Workplace place;
  expect_refused(place, {"identify", "plan", actuator()}, "--rig is required");
  expect_refused(place, plan_words({"--separate", "viscous_fricton"}),
                 "did you mean \"viscous_friction\"?");
  expect_refused(place, {"identify", "plan", actuator(), "--rig", rig(), "--duration", "2"},
                 "is not between 8 and 600 s");
  expect_refused(place, plan_words({"--noise", "torque=1"}), "no such quantity");
  expect_refused(place, plan_words({"--noise", "output_torque_Nm=-1"}), "a number from 0 to 1e+09");
  expect_refused(place, plan_words({"-o", rig()}), "bench_rig.json");
  expect_refused(
      place, {"identify", "plan", actuator(), "--rig", in_repository("specs/rig/serial_arm.json")},
      "only rigs of one joint");
}

std::string excitation(const std::string& header, const std::string& row) {
  std::string text = header + "\n";
  for (int k = 0; k < 50; ++k) text += std::to_string(0.01 * k) + row + "\n";
  return text;
}

TEST(IdentifySimulate, TheSameSeedGivesTheSameLog) {
  const Workplace place;
  place.write("e.csv",
              excitation("time_s,motor_current_A,output_velocity_rad_s,run", ",2,1,run_4"));
  const auto log = [&](const std::string& seed) {
    return place
        .run({"identify", "simulate", actuator(), "--rig", rig(), "--excitation", "e.csv",
              "--noise", "output_torque_Nm=0.1", "--seed", seed})
        .out;
  };
  EXPECT_EQ(log("1"), log("1"));
  EXPECT_NE(log("1"), log("2"));
}

// Oracle: closed form. A dynamometer turns at constant speed: torque is N Kt i, angle is w t.
TEST(IdentifySimulate, WritesTheRigsColumnsWithTheirValues) {
  const Workplace place;
  place.write("e.csv",
              excitation("time_s,motor_current_A,output_velocity_rad_s,run", ",2,1,run_4"));
  const Outcome outcome =
      place.run({"identify", "simulate", actuator(), "--rig", rig(), "--excitation", "e.csv"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  SpoiltLog log(outcome.out);
  ASSERT_EQ(log.rows.size(), 50u);
  EXPECT_NEAR(log.number(20, "tau_Nm"), 9.3 * 0.0865 * 2.0, 1e-6);
  EXPECT_NEAR(log.number(20, "q_rad"), 0.2, 1e-6);
  EXPECT_EQ(log.at(20, "run"), "run_4");
}

// By hand: a duty of 1 is a full bridge; the drive's peak, and N Kt times it at the output, may be
// played, a hundredth more may not.
TEST(IdentifySimulate, PlaysWhatTheDriveCanAndNoMore) {
  const Workplace place;
  const json drive = json::parse(text_of(actuator()));
  const double peak_A = drive["drive"]["peak_current_A"];
  const double peak_Nm = peak_A * 9.3 * 0.0865;
  const auto played = [&](const std::string& column, double value) {
    place.write("e.csv", excitation("time_s," + column + ",output_velocity_rad_s,run",
                                    "," + std::to_string(value) + ",1,run_4"));
    return place.run({"identify", "simulate", actuator(), "--rig", rig(), "--excitation", "e.csv"});
  };
  for (const auto& [column, most] : {std::pair{"motor_current_A", peak_A},
                                     std::pair{"commanded_torque_Nm", peak_Nm},
                                     {"duty", 1.0}}) {
    EXPECT_EQ(played(column, 0.999 * most).exit_code, 0) << column;
    EXPECT_EQ(played(column, -0.999 * most).exit_code, 0) << column;
    for (const double sign : {1.0, -1.0}) {
      const Outcome outcome = played(column, 1.01 * sign * most);
      EXPECT_EQ(outcome.exit_code, 2) << column;
      EXPECT_NE(outcome.err.find("e.csv: line 2, column 2 ("), std::string::npos) << outcome.err;
      EXPECT_NE(outcome.err.find("must be from -"), std::string::npos) << outcome.err;
    }
  }
}

TEST(IdentifyPlan, NamesTheLimitThatLeavesNoMotion) {
  const Workplace place;
  expect_refused(place, plan_words({"--position-range", "1e-9"}),
                 "--position-range: 1e-09 rad leave no motion that shows anything");
  expect_refused(place, plan_words({"--noise", "bus_voltage_V=2"}),
                 "has no column of bus_voltage_V");
  expect_refused(place,
                 plan_words({"--noise", "output_torque_Nm=1", "--noise", "output_torque_Nm=2"}),
                 "--noise: \"output_torque_Nm\" is given twice");
}

TEST(IdentifySimulate, RefusesWhatCannotBePlayed) {
  const Workplace place;
  const auto simulate = [&](const std::string& text, const Words& more = {}) {
    place.write("e.csv", text);
    Words words = {"identify", "simulate", actuator(), "--rig", rig(), "--excitation", "e.csv"};
    words.insert(words.end(), more.begin(), more.end());
    return words;
  };
  const std::string good = excitation("time_s,motor_current_A,output_velocity_rad_s,run", ",2,1,a");
  expect_refused(place, simulate(excitation("time_s,motor_current_A", ",2")),
                 "output_velocity_rad_s");
  expect_refused(place, simulate(excitation("time_s,motor_curent_A,output_velocity_rad_s", ",2,1")),
                 "nothing drives: a column motor_current_A");
  expect_refused(
      place, simulate(excitation("time_s,motor_current_A,output_velocity_rad_s,run", ",nan,1,a")),
      "nan");
  expect_refused(
      place, simulate(excitation("time_s,duty,output_velocity_rad_s", ",1.01,1")),
      "e.csv: line 2, column 2 (duty): a duty of 1.01 is not possible; it must be from -1 to 1");
  expect_refused(
      place, simulate(excitation("time_s,motor_current_A,output_velocity_rad_s,torqe", ",2,1,0")),
      "e.csv: the column \"torqe\" would not be played");
  expect_refused(
      place, simulate("time_s,motor_current_A,output_velocity_rad_s\n0,2,1\n10001,2,1\n"),
      "e.csv: its runs last 10001 s in all, 4e+07 steps of 0.00025 s; at most 4e+07 steps "
      "are simulated, 10000 s");
  expect_refused(place, simulate(good, {"--seed", "3"}), "--seed requires --noise");
  expect_refused(place, simulate(good, {"--noise", "bus_voltage_V=2"}),
                 "has no column of bus_voltage_V");
  expect_refused(
      place, simulate(good, {"--noise", "output_torque_Nm=0.1", "--noise", "output_torque_Nm=5"}),
      "--noise: \"output_torque_Nm\" is given twice");
  expect_refused(place, simulate(good, {"--noise", "output_torque_Nm=0x1"}),
                 "SIGMA is a standard deviation");
  expect_refused(place, simulate(good, {"--noise", "output_torque_Nm=x"}),
                 "SIGMA is a standard deviation");
  for (const char* beyond : {"output_torque_Nm=1e308", "output_torque_Nm=-1"}) {
    expect_refused(place, simulate(good, {"--noise", beyond}), "a number from 0 to 1e+09");
  }
  expect_refused(place, simulate(good, {"--noise", "output_torque_Nm"}), "QUANTITY=SIGMA");
  expect_refused(place,
                 {"identify", "simulate", actuator(), "--rig", rig(), "--excitation", "absent.csv"},
                 "absent.csv");
}

/// A rig of the example's planar leg, held by its trunk.
std::string leg_rig() {
  return json{{"kind", "rig"},
              {"version", 1},
              {"columns",
               {{"time_s", "time_s"},
                {"{j}_command", {{"quantity", "commanded_position_rad"}, {"joint", "{j}"}}},
                {"{j}_rad", {{"quantity", "output_position_rad"}, {"joint", "{j}"}}}}},
              {"controller", {{"type", "pd"}, {"stiffness_Nm_rad", 40}, {"damping_Nm_s_rad", 0.5}}}}
      .dump();
}

Words leg_words(const Words& more) {
  Words words = {"identify",   "plan",    "--rig",
                 "rig.json",   "--robot", in_repository("specs/robot/planar_leg.json").string(),
                 "--duration", "8"};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

// Oracle: the document's ranges, 0.1 to 2.6 rad of the knee and -2.2 to 1 of the hip, and its
// posture "stand", where each run begins and ends.
TEST(IdentifyPlan, PlansForAllJointsOfARobot) {
  const Workplace place;
  place.write("rig.json", leg_rig());
  const Outcome planned = place.run(leg_words({"-o", "commands.csv", "--json"}));
  ASSERT_TRUE(planned.exit_code == 0 || planned.exit_code == 3) << planned.err;
  const json plan = json::parse(planned.out);
  EXPECT_EQ(plan["separable"], planned.exit_code == 0);
  for (const char* joint : {"hip", "knee"}) {
    const auto is_friction = [&](const json& each) {
      return each["joint"] == joint && each["name"] == "coulomb_Nm" && each["told"];
    };
    EXPECT_TRUE(std::any_of(plan["values"].begin(), plan["values"].end(), is_friction)) << joint;
  }
  const SpoiltLog commands(place.text("commands.csv"));
  EXPECT_EQ(commands.header,
            (std::vector<std::string>{"run", "time_s", "hip_commanded_position_rad",
                                      "knee_commanded_position_rad"}));
  EXPECT_EQ(std::stod(commands.rows.front()[2]), -0.7);
  EXPECT_EQ(std::stod(commands.rows.back()[3]), 1.5);
  for (const auto& row : commands.rows) {
    EXPECT_GT(std::stod(row[2]), -2.2);
    EXPECT_LT(std::stod(row[2]), 1.0);
    EXPECT_GT(std::stod(row[3]), 0.1);
    EXPECT_LT(std::stod(row[3]), 2.6);
  }
}

TEST(IdentifyPlan, RefusesWhatARobotsPlanDoesNotTake) {
  const Workplace place;
  place.write("rig.json", leg_rig());
  const std::pair<Words, const char*> cases[] = {
      {{"--posture", "stnad"}, "--posture: the robot has no posture \"stnad\"; did you mean"},
      {{"--separate", "coulomb_friction"}, "--separate: a robot's plan is for all of its values"},
      {{"--actuator", "ankle=x.json"}, "the rig has no joint \"ankle\""},
      {{"--base-height", "0.1"}, "--posture: the robot cannot stand where its motion is to begin"},
      {{"--noise", "output_position_rad=0"}, "must be above 0 rad"},
      {{actuator()}, "the rig moves a robot, whose drives are its document's"}};
  for (const auto& [more, said] : cases) expect_refused(place, leg_words(more), said);
  expect_refused(place,
                 {"identify", "plan", "--rig", "rig.json", "--robot",
                  in_repository("specs/robot/planar_leg.json").string(), "--duration", "4"},
                 "--duration: 4 s is not between 8 and 600 s");
  expect_refused(place, plan_words({"--posture", "stand"}),
                 "--posture: the rig moves no robot; leave the option out");
}

}  // namespace
}  // namespace torquewright::cli_test::plan
