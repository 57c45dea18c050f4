// SPDX-License-Identifier: Apache-2.0
// `hopper check` as users start it: verdicts, documents, and what it says to bad input.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "io/documents/document.hpp"
#include "io/files/csv.hpp"
#include "tests/cli/workplace.hpp"

namespace torquewright::cli_test {
namespace {

using nlohmann::json;
using Words = std::vector<std::string>;

/// A crane: an arm of 1 kg at 0.5 m on a hinge at 1 m, driven by the published knee.
json crane() {
  return json::parse(R"({"kind": "robot", "version": 1, "name": "crane",
    "base": {"body": "post", "motion": "planar"},
    "bodies": [
      {"name": "post", "mass_kg": 10, "center_of_mass_m": [0, 0, 0.2], "inertia_kg_m2": 1},
      {"name": "arm", "mass_kg": 1, "center_of_mass_m": [0.5, 0, 0], "inertia_kg_m2": 0.1}],
    "joints": [{"name": "elbow", "type": "revolute", "parent": "post", "child": "arm",
      "position_m": [0, 0, 1], "axis": [0, 1, 0], "range_rad": [-1, 1]}],
    "contacts": [
      {"name": "front", "body": "post", "position_m": [0.5, 0, 0], "friction_coefficient": 0.5},
      {"name": "rear", "body": "post", "position_m": [-0.5, 0, 0], "friction_coefficient": 0.5}],
    "mechanisms": [{"type": "direct", "joints": ["elbow"], "actuators": ["knee.json"]}]})");
}

/// The same with a hand at the arm's end, whose wrist has a drive like the elbow's.
json crane_with_wrist(double hand_kg) {
  json robot = crane();
  robot["bodies"].push_back({{"name", "hand"},
                             {"mass_kg", hand_kg},
                             {"center_of_mass_m", {0, 0, 0}},
                             {"inertia_kg_m2", 0.01}});
  robot["joints"].push_back({{"name", "wrist"},
                             {"type", "revolute"},
                             {"parent", "arm"},
                             {"child", "hand"},
                             {"position_m", {1, 0, 0}},
                             {"axis", {0, 1, 0}}});
  robot["mechanisms"].push_back(
      {{"type", "direct"}, {"joints", {"wrist"}}, {"actuators", {"knee.json"}}});
  return robot;
}

/// The arm swings, the post stands.
std::string swing(double amplitude_rad) {
  std::string csv =
      "time_s,base_x_position_m,base_z_position_m,base_pitch_position_rad,elbow_position_rad\n";
  for (int i = 0; i <= 400; ++i) {
    const double t = 0.005 * i;
    csv += fmt::format("{},0,0,0,{}\n", t, amplitude_rad * (1 - std::cos(3 * t)) / 2);
  }
  return csv;
}

class HopperCheck : public testing::Test {
 protected:
  void SetUp() override {
    place_.write("knee.json", text_of(in_repository("specs/actuator/d151_knee.json")));
  }

  Outcome check(const json& robot, const std::string& motion,
                const std::vector<std::string>& more = {}) {
    place_.write("robot.json", robot.dump());
    place_.write("motion.csv", motion);
    std::vector<std::string> arguments{"hopper", "check", "robot.json", "motion.csv"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return place_.run(arguments);
  }

  void expect_refusal(const json& robot, const std::string& motion, const std::string& sentence,
                      const std::vector<std::string>& more = {}) {
    const Outcome outcome = check(robot, motion, more);
    EXPECT_EQ(outcome.exit_code, 2) << outcome.out;
    EXPECT_NE(outcome.err.find(sentence), std::string::npos) << outcome.err;
    EXPECT_TRUE(outcome.out.empty());
  }

  Workplace place_;
};

TEST_F(HopperCheck, SaysWhereTheRowsAreThatNoWindowHolds) {
  expect_refusal(crane(), swing(0.5),
                 "motion.csv: no rows lie between --from 7 s and --until 9 s; the file's go from "
                 "0 s to 2 s\n",
                 {"--from", "7", "--until", "9"});
}

// A misspelt header would be missing in silence, a wrong unit would count.
TEST_F(HopperCheck, NotesWhatItDoesNotReadAndUnitsThatContradictNames) {
  std::string motion = swing(0.5);
  motion.insert(motion.find('\n'), ",elbow_torqe_Nm");
  for (std::size_t end = motion.find('\n', motion.find('\n') + 1); end != std::string::npos;
       end = motion.find('\n', end + 3)) {
    motion.insert(end, ",1");
  }
  const Outcome outcome =
      check(crane(), motion, {"--column", "base_x_position_m=base_x.position:mm"});
  EXPECT_NE(outcome.out.find("not read: \"elbow_torqe_Nm\" (is near elbow_torque_Nm, which is "
                             "missing)"),
            std::string::npos)
      << outcome.out << outcome.err;
  EXPECT_NE(outcome.out.find("\"base_x_position_m\" is read in mm, as is stated, though its name "
                             "ends in m"),
            std::string::npos)
      << outcome.out;
}

// A row counter before the time, which would make the swing last a thousand times as long.
TEST_F(HopperCheck, RefusesTwoColumnsThatMayBeTheTime) {
  std::string counted;
  std::size_t row = 0;
  std::istringstream lines(swing(0.5));
  for (std::string line; std::getline(lines, line); ++row) {
    counted += (row == 0 ? "t" : std::to_string(row)) + "," + line + "\n";
  }
  expect_refusal(crane(), counted,
                 "motion.csv: \"t\" and \"time_s\" may both be the time; say which it is, --column "
                 "time_s=time:s or --column t=time:s\n");
  EXPECT_EQ(check(crane(), counted, {"--column", "time_s=time:s"}).exit_code,
            check(crane(), swing(0.5)).exit_code);
}

// Oracle: a count. As many runs as its charge goes into the battery are done, and one more is not.
TEST_F(HopperCheck, RunsThatDrainTheBatteryAreAViolation) {
  json robot = crane();
  robot["battery"] = {{"series_cells", 16},
                      {"parallel_cells", 1},
                      {"cell_open_circuit_V", 4.2},
                      {"cell_resistance_ohm", 0.0},
                      {"cell_capacity_Ah", 0.1}};
  const auto charge = [&](std::size_t runs, int exit_code) {
    const Outcome outcome = check(robot, swing(0.5), {"--json", "--repeat", std::to_string(runs)});
    EXPECT_EQ(outcome.exit_code, exit_code) << outcome.out << outcome.err;
    const json report = json::parse(outcome.out);
    for (const json& finding : report["findings"]) {
      if (finding["rule"] == "battery-charge") return finding;
    }
    return json();
  };
  const json once = charge(1, 0);
  EXPECT_EQ(once["limit"], 0.1);
  const auto most = static_cast<std::size_t>(0.1 / once["value"].get<double>());
  EXPECT_EQ(charge(most, 0)["severity"], "note");
  EXPECT_EQ(charge(most + 1, 1)["severity"], "violation");
}

// Oracle: statics. The arm's weight at 0.5 m is 4.905 Nm at the elbow where it lies flat.
TEST_F(HopperCheck, PassesAndReportsByItsSchema) {
  const Outcome outcome = check(crane(), swing(0.0), {"--json"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const json report = json::parse(outcome.out);
  EXPECT_NO_THROW(io::check_document(report, "check_report", "report", ""));
  EXPECT_EQ(report["verdict"], "pass");
  EXPECT_NEAR(report["joints"][0]["peak_torque_Nm"].get<double>(), 9.81 * 0.5, 1e-9);
  EXPECT_LE(report["base_residual"]["force"]["mean"].get<double>(), 1e-3);
  EXPECT_NEAR(report["base_residual"]["weight_N"].get<double>(), 11 * 9.81, 1e-9);
  EXPECT_EQ(report["transmission_load"].size(), 1u);
  EXPECT_NEAR(report["transmission_load"][0]["joint_Nm"].get<double>(), 9.81 * 0.5, 1e-9);
  EXPECT_NEAR(report["contact_load"][0]["joint_Nm"].get<double>(), 0.0, 1e-6);
}

// One line of the drive on the screen: 4.905 Nm held, the rest behind --all.
TEST_F(HopperCheck, AnswersOnOneScreen) {
  const Outcome screen = check(crane(), swing(0.0));
  EXPECT_EQ(screen.exit_code, 0) << screen.err;
  EXPECT_LE(std::count(screen.out.begin(), screen.out.end(), '\n'), 12) << screen.out;
  const std::size_t line = screen.out.find("\n  elbow ");
  ASSERT_NE(line, std::string::npos) << screen.out;
  EXPECT_NE(screen.out.find("4.905", line), std::string::npos);
  EXPECT_NE(screen.out.find("pass\n", line), std::string::npos);
  EXPECT_NE(screen.out.find("notes, on what is assumed"), std::string::npos);
  EXPECT_NE(screen.out.find("\nnext: torquewright hopper replay "), std::string::npos);
  EXPECT_EQ(screen.out.find("  margin   "), std::string::npos);
  EXPECT_NE(check(crane(), swing(0.0), {"--all"}).out.find("  margin   "), std::string::npos);
}

TEST_F(HopperCheck, GoesOnByTheWordThatItWasCalledBy) {
  for (const std::string word : {"hopper", "robot"}) {
    const Outcome outcome = Workplace().run(
        {word, "check", in_specs("robot/hopper.json"), in_specs("trajectory/hopper_squat.csv")});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("\nnext: torquewright " + word + " replay "), std::string::npos)
        << outcome.out;
  }
}

// `hopper replay` refuses what cannot fall.
TEST_F(HopperCheck, SendsNothingToAReplayThatStandsFixed) {
  json robot = crane();
  robot["base"]["motion"] = "fixed";
  robot.erase("contacts");
  const Outcome outcome =
      check(robot, "time_s,elbow_position_rad\n0,0\n0.1,0\n0.2,0\n0.3,0\n0.4,0\n0.5,0\n");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("\nnext: torquewright hopper check "), std::string::npos)
      << outcome.out;
}

// The elbow holds the arm with 4.905 Nm, which its gears pass, touching or not.
TEST_F(HopperCheck, FailsWhereTheGearsPassMoreThanTheyBear) {
  json robot = crane();
  robot["mechanisms"][0]["transmission_limit"] = {{"torque_Nm", 4.9}, {"side", "joint"}};
  const Outcome fails = check(robot, swing(0.0));
  EXPECT_EQ(fails.exit_code, 1);
  EXPECT_NE(fails.out.find("violation [transmission-load] elbow: 4.905 Nm at the joint, 0.2453 Nm "
                           "at the motor pass its gears"),
            std::string::npos)
      << fails.out;
  robot["mechanisms"][0]["transmission_limit"]["torque_Nm"] = 4.91;
  EXPECT_EQ(check(robot, swing(0.0)).exit_code, 0);
}

// Columns that the report's figures can be found in again, as a CSV that this tool reads.
TEST_F(HopperCheck, WritesEverythingByTime) {
  const Outcome outcome = check(crane(), swing(0.5), {"--series", "series.csv", "--json"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  io::CsvReader csv(place_.path("series.csv"));
  const auto torque = csv.find("elbow_drive_torque_Nm");
  const auto up = csv.find("front_force_z_N");
  ASSERT_TRUE(torque && up && csv.find("elbow_current_A") && csv.find("elbow_bus_voltage_V") &&
              csv.find("base_residual_moment_y_Nm") && csv.find("elbow_torque_margin_Nm"));
  double peak_Nm = 0.0;
  int rows = 0;
  for (; csv.next(); ++rows) {
    peak_Nm = std::max(peak_Nm, std::abs(csv.number(*torque)));
    EXPECT_GT(csv.number(*up), 0.0);
  }
  EXPECT_EQ(rows, 401);
  EXPECT_NEAR(peak_Nm, json::parse(outcome.out)["joints"][0]["peak_torque_Nm"].get<double>(), 1e-6);
  expect_refusal(crane(), swing(0.5), "motion.csv", {"--series", "motion.csv"});
}

// Oracle: the file. At rest nothing but weight pulls: what else a column holds is no digit beside
// the greatest of its unit.
TEST_F(HopperCheck, WritesNoNoiseByTime) {
  ASSERT_EQ(check(crane(), swing(0.5), {"--series", "series.csv"}).exit_code, 0);
  io::CsvReader csv(place_.path("series.csv"));
  double greatest_N = 0.0;
  std::vector<double> forces_N;
  while (csv.next()) {
    for (std::size_t i = 0; i < csv.header().size(); ++i) {
      if (!csv.header()[i].ends_with("_N") || csv.text(i).empty()) continue;
      forces_N.push_back(std::abs(csv.number(i)));
      greatest_N = std::max(greatest_N, forces_N.back());
    }
  }
  ASSERT_GT(greatest_N, 50.0);
  for (const double force_N : forces_N) {
    EXPECT_TRUE(force_N == 0.0 || force_N > 4e-11 * greatest_N) << force_N;
  }
}

// Oracle: all that --all lists.
TEST_F(HopperCheck, ListsFindingsByTheirSeverity) {
  const auto listed = [](const std::string& text, const std::string& severity) {
    std::istringstream stream(text);
    int count = 0;
    for (std::string line; std::getline(stream, line);) count += line.starts_with(severity + " [");
    return count;
  };
  const std::string all = check(crane(), swing(0.5), {"--all"}).out;
  ASSERT_GT(listed(all, "note"), 0);
  for (const Words& more : {Words{"--all"}, Words{}}) {
    Words words = more;
    words.insert(words.end(), {"--severity", "warning"});
    const std::string warnings = check(crane(), swing(0.5), words).out;
    EXPECT_EQ(listed(warnings, "note"), 0);
    EXPECT_EQ(listed(warnings, "warning"), listed(all, "warning"));
    words.back() = "error";
    const std::string errors = check(crane(), swing(0.5), words).out;
    EXPECT_EQ(listed(errors, "warning"), 0);
    EXPECT_EQ(listed(errors, "violation"), listed(all, "violation"));
    EXPECT_EQ(errors.substr(0, errors.find('\n')), all.substr(0, all.find('\n')));
  }
  expect_refusal(crane(), swing(0.5), "\"fatal\" is not one of error, warning, note",
                 {"--severity", "fatal"});
}

// Three panels, and nothing where the file tells no motion of the base.
// Two rows of positions are a velocity and no acceleration, not one of zero.
TEST_F(HopperCheck, RefusesRatesThatTooFewRowsHold) {
  expect_refusal(crane(), "time_s,elbow_position_rad,elbow_torque_Nm\n0,0,5\n1,0,5\n",
                 "accelerations cannot be had from fewer than 3 rows, and there are two");
}

TEST_F(HopperCheck, DrawsTheMomentum) {
  const Outcome outcome = check(crane(), swing(0.5), {"--plot-momentum", "momentum.svg"});
  if (outcome.err.find("not installed") != std::string::npos) GTEST_SKIP() << "no gnuplot";
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  const std::string picture = place_.text("momentum.svg");
  for (const char* words : {"CAM", "Nm s", "CAV", "rad/s", "composite inertia", "time in s"}) {
    EXPECT_NE(picture.find(words), std::string::npos) << words;
  }
  EXPECT_EQ(picture.find("take-off"), std::string::npos) << "nothing flies";
  expect_refusal(crane(), swing(0.5), "momentum.pdf", {"--plot-momentum", "momentum.pdf"});
  expect_refusal(crane(), swing(0.5), "motion.csv", {"--plot-momentum", "motion.csv"});
  const Outcome floating =
      check(crane(), "time_s,elbow_position_rad,elbow_torque_Nm\n0,0,5\n1,0,5\n2,0,5\n",
            {"--plot-momentum", "none.svg"});
  EXPECT_NE(floating.err.find("none.svg: not drawn"), std::string::npos) << floating.err;
  EXPECT_FALSE(place_.has("none.svg"));
}

// Pushed at a constant speed beyond no-load, either way: text, JSON and page tell what the drive
// must do and what it is asked to do. Oracle: the signs; 13 V of 67 lack at that speed, which is
// braking.
TEST_F(HopperCheck, TellsOfTorqueBeyondNoLoadSpeedByItsSense) {
  for (const int sign : {-1, 1}) {
    std::string motion = "time_s,elbow_position_rad,elbow_velocity_rad_s,elbow_torque_Nm\n";
    for (int i = 0; i < 10; ++i) {
      motion += fmt::format("{},{},{},{}\n", 0.01 * i, sign * 0.125 * i, sign * 12.5, sign * 312);
    }
    const std::vector<std::string> asked{"--report", "page.html"};
    const std::string text = check(crane(), motion, asked).out;
    const json report = json::parse(check(crane(), motion, {"--json"}).out);
    std::string sentence = report["findings"][0]["sentence"];
    sentence = sentence.substr(sentence.find("at 12.5 rad/s"));
    EXPECT_TRUE(sentence.starts_with("at 12.5 rad/s the drive must brake with at least ")) << text;
    EXPECT_TRUE(sentence.ends_with("; it is asked to push with 312 Nm (voltage)")) << text;
    EXPECT_NE(text.find(sentence), std::string::npos) << text;
    EXPECT_NE(place_.text("page.html").find(sentence), std::string::npos);
    EXPECT_EQ(text.find("Nm beyond"), std::string::npos) << text;
  }
}

TEST_F(HopperCheck, FailsBeyondARangeAndSaysWhere) {
  const Outcome outcome = check(crane(), swing(1.2));
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_NE(outcome.out.find("violation [joint-range] elbow: position of 1.19999 rad"),
            std::string::npos)
      << outcome.out;
}

TEST_F(HopperCheck, TriesCandidatesAndSaysInOneLineWhyOneFails) {
  std::filesystem::create_directory(place_.path("candidates"));
  json weak = json::parse(text_of(in_repository("specs/actuator/d151_knee.json")));
  weak["drive"]["peak_current_A"] = 0.1;
  weak["drive"]["continuous_current_A"] = 0.05;
  weak.erase("datasheet");
  place_.write("candidates/weak.json", weak.dump());
  place_.write("candidates/strong.json", text_of(in_repository("specs/actuator/d151_knee.json")));
  place_.write("candidates/notes.json", "{}");
  const Outcome outcome = check(crane(), swing(0.5), {"--candidates", "candidates", "--json"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const json report = json::parse(outcome.out);
  EXPECT_NO_THROW(io::check_document(report, "check_report", "report", ""));
  ASSERT_EQ(report["candidates"].size(), 2u);
  EXPECT_EQ(report["candidates"][0]["candidate"], "strong");
  EXPECT_EQ(report["candidates"][1]["verdict"], "fail");
  const std::string why = report["candidates"][1]["why"];
  EXPECT_NE(why.find("elbow at t = 0 s"), std::string::npos) << why;
  EXPECT_EQ(why.find('\n'), std::string::npos);
  EXPECT_NE(check(crane(), swing(0.5), {"--candidates", "candidates"}).out.find("not tried: notes"),
            std::string::npos);
}

// Oracle: the reflected inertia of a ratio N is N^2 times the rotor's 0.000922 kg m2.
TEST_F(HopperCheck, SweepsRatiosWithTheirRotorsInTheDemand) {
  std::filesystem::create_directory(place_.path("candidates"));
  place_.write("candidates/knee.json", text_of(in_repository("specs/actuator/d151_knee.json")));
  const Outcome outcome =
      check(crane(), swing(0.5),
            {"--candidates", "candidates", "--ratios", "8:30:2", "--threads", "2", "--json"});
  const json report = json::parse(outcome.out);
  ASSERT_EQ(report["candidates"].size(), 12u);
  for (const json& candidate : report["candidates"]) {
    const double ratio = candidate["ratio"];
    EXPECT_NEAR(candidate["rotor_inertia_kg_m2"].get<double>(), ratio * ratio * 0.000922, 1e-12);
    EXPECT_GT(candidate["peak_torque_Nm"].get<double>(), 0.0);
  }
}

TEST_F(HopperCheck, TheSameInputGivesTheSameBytesOnAnyThreads) {
  std::filesystem::create_directory(place_.path("candidates"));
  place_.write("candidates/knee.json", text_of(in_repository("specs/actuator/d151_knee.json")));
  const std::vector<std::string> one{"--candidates", "candidates", "--ratios", "8:30", "--json"};
  std::vector<std::string> two = one;
  two.insert(two.end(), {"--threads", "3"});
  EXPECT_EQ(check(crane(), swing(0.5), one).out, check(crane(), swing(0.5), two).out);
}

TEST_F(HopperCheck, OverwritesNoInputAndWritesAllOrNothing) {
  const std::string motion = swing(0.5);
  expect_refusal(crane(), motion, "motion.csv", {"--figures", "motion.csv"});
  EXPECT_EQ(place_.text("motion.csv"), motion);
  expect_refusal(crane(), motion, "nowhere", {"--figures", "a.svg", "-o", "nowhere/b.txt"});
  EXPECT_FALSE(place_.has("a.svg"));
  EXPECT_EQ(check(crane(), motion, {"--figures", "a.svg", "-o", "b.txt"}).exit_code, 0);
  EXPECT_TRUE(place_.has("a.svg") && place_.has("b.txt"));
  // Where nothing says how the base moves there is nothing to draw, and no empty file.
  const Outcome bare =
      check(crane(), "time_s,elbow_position_rad,elbow_torque_Nm\n0,0,1\n1,0,1\n2,0,1\n",
            {"--figures", "c.svg"});
  EXPECT_NE(bare.err.find("c.svg: not drawn"), std::string::npos) << bare.err;
  EXPECT_FALSE(place_.has("c.svg"));
}

// Oracle: a candidate 2 kg heavier, mounted 0.8 m out on the arm, adds 9.81 * 2 * 0.8 Nm to hold.
TEST_F(HopperCheck, CarriesTheMassOfACandidate) {
  json light = json::parse(text_of(in_repository("specs/actuator/d151_knee.json")));
  light["mass_kg"] = 1.5;
  place_.write("knee.json", light.dump());
  std::filesystem::create_directory(place_.path("candidates"));
  light["mass_kg"] = 3.5;
  place_.write("candidates/heavy.json", light.dump());
  json robot = crane();
  robot["mechanisms"][0]["mounted_on"] = {{"body", "arm"}, {"position_m", {0.8, 0, 0}}};
  const Outcome outcome = check(robot, swing(0.0), {"--candidates", "candidates", "--json"});
  const json report = json::parse(outcome.out);
  ASSERT_EQ(report["candidates"].size(), 1u);
  EXPECT_NEAR(report["candidates"][0]["peak_torque_Nm"].get<double>(), 9.81 * (0.5 + 2 * 0.8),
              1e-6);
  EXPECT_EQ(report["candidates"][0]["mass_kg"], 3.5);
}

// Oracles by hand: balls of 0.3 m, centres 1 m apart at the hand, reach each other when it folds to
// 0.5 m; a force of the file that pulls down is none of a ground.
TEST_F(HopperCheck, SaysWhereBodiesMeetAndWhereTheGroundWouldPull) {
  json robot = crane();
  robot["bodies"].push_back({{"name", "hand"},
                             {"mass_kg", 0.001},
                             {"center_of_mass_m", {0, 0, 0}},
                             {"inertia_kg_m2", 1e-6}});
  robot["joints"].push_back({{"name", "slide"},
                             {"type", "prismatic"},
                             {"parent", "arm"},
                             {"child", "hand"},
                             {"axis", {1, 0, 0}}});
  robot["collision_spheres"] = {{{"body", "post"}, {"center_m", {0, 0, 1}}, {"radius_m", 0.3}},
                                {{"body", "hand"}, {"center_m", {0, 0, 0}}, {"radius_m", 0.3}}};
  const std::string header =
      "time_s,base_x_position_m,base_z_position_m,base_pitch_position_rad,elbow_position_rad,"
      "slide_position_m";
  const auto slid = [&](double place_m) {
    std::string csv = header + "\n";
    for (int i = 0; i < 20; ++i) csv += fmt::format("{},0,0,0,0,{}\n", 0.01 * i, place_m);
    return csv;
  };
  EXPECT_EQ(check(robot, slid(0.61)).exit_code, 0);
  const Outcome meets = check(robot, slid(0.5));
  EXPECT_EQ(meets.exit_code, 1);
  EXPECT_NE(meets.out.find("[self-collision] post and hand meet: their spheres overlap by 0.1 m"),
            std::string::npos)
      << meets.out;
  std::string pulled =
      "time_s,base_x_position_m,base_z_position_m,base_pitch_position_rad,elbow_position_rad,"
      "front_force_z_N,rear_force_z_N\n";
  for (int i = 0; i < 20; ++i) pulled += fmt::format("{},0,0,0,0,200,-92.09\n", 0.01 * i);
  const Outcome outcome = check(crane(), pulled, {"--residual-limit", "10"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_NE(outcome.out.find("[ground-pulls] rear: the ground would have to pull, with 92.09 N"),
            std::string::npos)
      << outcome.out;
}

TEST_F(HopperCheck, RefusesAMotionThatIsNone) {
  // Half a metre up without a foot on the ground, and standing still.
  std::string motion = swing(0.0);
  for (std::size_t at = motion.find(",0,0,0,"); at != std::string::npos;
       at = motion.find(",0,0,0,", at + 1)) {
    motion.replace(at, 7, ",0,0.5,0,");
  }
  expect_refusal(crane(), motion,
                 "a force on the base of 107.9 N (mean of 10 ms). The limit is 10.79 N");
}

// Statics: the centre of mass stands at x = 0.5 / 11 = 0.0455 m. 25 mm beyond the front point 107.9
// N turn the post over with 2.7 Nm, however slowly; 5 mm within it stands.
TEST_F(HopperCheck, RefusesToStandBesideItsFeet) {
  json robot = crane();
  robot["contacts"][0]["position_m"][0] = 0.0205;
  expect_refusal(robot, swing(0.0), "It would topple or slide away");
  robot["contacts"][0]["position_m"][0] = 0.0505;
  EXPECT_EQ(check(robot, swing(0.0)).exit_code, 0);
}

// Without gravity what is at rest stays so, in the air too; limits are then shares of the Earth's.
TEST_F(HopperCheck, LetsARobotRestWithoutGravity) {
  json robot = crane();
  robot["gravity_m_s2"] = 0;
  std::string motion = swing(0.0);
  for (std::size_t at = motion.find(",0,0,0,"); at != std::string::npos;
       at = motion.find(",0,0,0,", at + 1)) {
    motion.replace(at, 7, ",0,1.1,0,");
  }
  const Outcome outcome = check(robot, motion, {"--json"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
  EXPECT_NEAR(json::parse(outcome.out)["joints"][0]["peak_torque_Nm"].get<double>(), 0.0, 1e-9);
}

TEST_F(HopperCheck, RefusesWithASentence) {
  const std::string good = swing(0.5);
  std::string other = good;
  other.replace(other.find("elbow"), 5, "elbwo");
  expect_refusal(crane(), other, "did you mean \"elbwo_position_rad\"?");
  std::string backwards = good;
  backwards.insert(backwards.find("0.015,"), "0.5,0,0,0,0\n");
  expect_refusal(crane(), backwards, "time runs backwards");
  std::string twice = good;
  twice.insert(twice.find("0.015,"), "0.01,0,0,0,0.2\n");
  expect_refusal(crane(), twice, "time repeats");
  std::string wrapped = good;
  wrapped.insert(wrapped.find("0.015,"), "0.012,0,0,0,4.7\n");  // a quarter turn short of one
  expect_refusal(crane(), wrapped, "a wrapped angle? Unwrap it");
  std::string hole = good;
  hole.insert(hole.find("0.015,"), "0.012,0,0,0,nan\n");
  expect_refusal(crane(), hole, "motion.csv");
  expect_refusal(crane(), "time_s,elbow_position_rad\n0,0\n", "says neither how the base moves");
  expect_refusal(crane(), "time_s,base_x_position_m,elbow_position_rad\n0,0,0\n",
                 "though others of the base are there");
  expect_refusal(crane(), good, "is no folder", {"--candidates", "nowhere"});
  expect_refusal(crane(), good, "is for --candidates", {"--ratios", "8:30"});
  expect_refusal(crane(), good, "FROM:TO", {"--candidates", ".", "--ratios", "eight"});
  for (const char* beyond : {"1e-306:9", "0.009:9", "1:10001", "5e-324:1e308"}) {
    expect_refusal(crane(), good, "ratios are from 0.01 to 10000",
                   {"--candidates", ".", "--ratios", beyond});
  }
  expect_refusal(crane(), good, "has no unit", {"--column", "x=front.contact:m"});
  expect_refusal(crane(), good, "did you mean \"elbow\"?", {"--column", "x=elbo.position"});
  expect_refusal(crane(), good, "no column elbow_position_rad for robot \"crane\"",
                 {"--column", "elbow_position_rad=elbow.torque"});
  expect_refusal(crane(), good, "time is no joint's; leave \"elbo.\" out",
                 {"--column", "time_s=elbo.time:ms"});
  expect_refusal(crane(), good, "no torque of every driven joint", {"--torques", "file"});
}

/// The swing with a column beside it that holds the same number in every row.
std::string with_column(const std::string& motion, const std::string& header,
                        const std::string& value) {
  std::istringstream lines(motion);
  std::string more;
  for (std::string line; std::getline(lines, line);) {
    more += line + "," + (more.empty() ? header : value) + "\n";
  }
  return more;
}

// A column that is left aside in silence is one that somebody believes was checked.
TEST_F(HopperCheck, RefusesColumnsInUnitsThatNobodyStated) {
  const std::string in_mNm = with_column(swing(0.5), "elbow_torque_mNm", "0");
  expect_refusal(crane(), in_mNm,
                 "\"elbow_torque_mNm\" says mNm; state its unit, --column "
                 "elbow_torque_mNm=elbow.torque:mNm");
  expect_refusal(crane(), in_mNm, "says mNm", {"--column", "elbow_torque_mNm=elbow.torque"});
  const std::string stated = "elbow_torque_mNm=elbow.torque:mNm";
  EXPECT_NE(check(crane(), in_mNm, {"--column", stated}).exit_code, 2);
  expect_refusal(crane(), with_column(swing(0.5), "elbow_velocity_deg_s", "0"), "says deg/s");
  // What is there in SI already may stand in another unit too, and words of ours are others' too.
  const std::string both = with_column(swing(0.5), "elbow_position_deg", "0");
  EXPECT_NE(check(crane(), both).exit_code, 2);
  const std::string foreign = with_column(swing(0.5), "elbow_torque_command", "0");
  EXPECT_NE(check(crane(), foreign).exit_code, 2);
  // Whatever the column is called, and however its name says it.
  for (const std::string name : {"tau_mNm", "tau [mNm]"}) {
    const std::string motion = with_column(swing(0.5), name, "0");
    expect_refusal(crane(), motion, "says mNm", {"--column", name + "=elbow.torque"});
    EXPECT_NE(check(crane(), motion, {"--column", name + "=elbow.torque:Nm"}).exit_code, 2);
  }
}

TEST_F(HopperCheck, RefusesTorquesOfSomeDrivenJointsAlone) {
  const json robot = crane_with_wrist(0.1);
  const std::string both = with_column(swing(0.5), "wrist_position_rad", "0");
  const std::string one = with_column(both, "elbow_torque_Nm", "0");
  expect_refusal(robot, one, "has torques of elbow and none of wrist");
  EXPECT_NE(check(robot, one, {"--torques", "dynamics"}).exit_code, 2);
  EXPECT_NE(check(robot, with_column(one, "wrist_torque_Nm", "0")).exit_code, 2);
}

TEST_F(HopperCheck, RefusesAFactorOfNothing) {
  place_.write("columns.json", R"({"kind": "trajectory_columns", "version": 1, "columns": [
    {"column": "a", "joint": "elbow", "quantity": "torque", "factor": 0}]})");
  expect_refusal(crane(), with_column(swing(0.5), "a", "1"), "/columns/0/factor: 0 would leave",
                 {"--columns", "columns.json"});
}

// The knee states no battery: the robot's is what lacks a curve, or there is none anywhere.
TEST_F(HopperCheck, LooksForAChargeWhereTheBatteryIs) {
  json robot = crane();
  json knee = json::parse(place_.text("knee.json"));
  knee.erase("battery");
  place_.write("knee.json", knee.dump());
  const Words charge{"--state-of-charge", "0.5"};
  expect_refusal(robot, swing(0.5), "robot.json: a state of charge needs /battery", charge);
  robot["battery"] = {{"series_cells", 16},
                      {"parallel_cells", 4},
                      {"cell_open_circuit_V", 4.2},
                      {"cell_resistance_ohm", 0.001}};
  expect_refusal(robot, swing(0.5), "robot.json: a state of charge needs /battery", charge);
  knee["battery"] = robot["battery"];
  place_.write("knee.json", knee.dump());
  expect_refusal(robot, swing(0.5), "knee.json: a state of charge needs /battery", charge);
}

TEST_F(HopperCheck, RefusesOptionsWithoutEffect) {
  expect_refusal(crane(), swing(0.5), "--candidates", {"--threads", "2"});
}

// An angle kept within a turn is the same motion, and the report says what was done to it.
TEST_F(HopperCheck, LetsAWrappedAngleRunOn) {
  std::string plain, wrapped;
  plain = wrapped =
      "time_s,base_x_position_m,base_z_position_m,base_pitch_position_rad,elbow_position_rad\n";
  for (int i = 0; i <= 400; ++i) {
    const double angle = 3.0 + 0.3 * (1 - std::cos(3 * 0.005 * i)) / 2;  // past pi and back
    plain += fmt::format("{},0,0,0,{}\n", 0.005 * i, angle);
    wrapped += fmt::format("{},0,0,0,{}\n", 0.005 * i, std::remainder(angle, 2 * M_PI));
  }
  json robot = crane();
  robot["joints"][0].erase("range_rad");
  const Outcome outcome = check(robot, wrapped, {"--json"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  const json found = json::parse(outcome.out);
  EXPECT_NO_THROW(io::check_document(found, "check_report", "report", ""));
  EXPECT_NE(
      outcome.out.find("elbow_position_rad jumps by a whole turn 2 times, first at t = 0.505 s"),
      std::string::npos);
  const json straight = json::parse(check(robot, plain, {"--json"}).out);
  EXPECT_NEAR(found["joints"][0]["peak_torque_Nm"].get<double>(),
              straight["joints"][0]["peak_torque_Nm"].get<double>(), 1e-6);
}

TEST_F(HopperCheck, RefusesVelocitiesThatAreNone) {
  std::string motion =
      "time_s,base_x_position_m,base_z_position_m,base_pitch_position_rad,elbow_position_rad,"
      "base_x_velocity_m_s,base_z_velocity_m_s,base_pitch_velocity_rad_s,elbow_velocity_rad_s\n";
  for (int i = 0; i <= 400; ++i) {
    const double t = 5.0 * i;  // milliseconds
    motion += fmt::format("{},0,0,0,{},0,0,0,{}\n", t, 0.25 * (1 - std::cos(3e-3 * t)),
                          0.75 * std::sin(3e-3 * t));
  }
  expect_refusal(crane(), motion, "s: the velocity of elbow is not the rate of its position");
  expect_refusal(crane(), motion, "likely cause: time_s seems to be in milliseconds");
  EXPECT_EQ(check(crane(), motion, {"--column", "time_s=time:ms"}).exit_code, 0);
}

// An extreme of either sort: an arm of 1 kg needs some 5 Nm.
TEST_F(HopperCheck, HoldsJointsWithoutDrivesToWhatTheyState) {
  json limited = crane();
  limited.erase("mechanisms");
  limited["joints"][0]["torque_limit_Nm"] = 500;
  limited["joints"][0]["speed_limit_rad_s"] = 100;
  const Outcome passes = check(limited, swing(0));
  EXPECT_EQ(passes.exit_code, 0) << passes.out << passes.err;
  EXPECT_NE(passes.out.find("no mechanism drives elbow. Their own limits"), std::string::npos)
      << passes.out;
  limited["joints"][0]["torque_limit_Nm"] = 0.5;
  EXPECT_EQ(check(limited, swing(0)).exit_code, 1);
}

TEST_F(HopperCheck, RefusesRobotsThatAreNone) {
  json thin = crane();
  thin["bodies"][1]["inertia_kg_m2"] = {{"xx", 1}, {"yy", 0.1}, {"zz", 0.1}};
  expect_refusal(thin, swing(0), "/bodies/1/inertia_kg_m2");
  json upside_down = crane();
  upside_down["joints"][0]["range_rad"] = {1, -1};
  expect_refusal(upside_down, swing(0), "least position first");
  json limit = crane();
  limit["mechanisms"][0]["transmission_limit"] = {{"torque_Nm", 3}};
  expect_refusal(limit, swing(0), "needs either torque_Nm and side");
  json idle = crane();
  idle.erase("mechanisms");
  expect_refusal(idle, swing(0), "states no mechanisms", {"--candidates", "."});
  const Outcome outcome = check(idle, swing(0));
  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_NE(outcome.out.find("no actuator to hold the motion against"), std::string::npos);
  json loop = crane();
  loop["joints"].push_back({{"name", "strut"},
                            {"type", "revolute"},
                            {"parent", "post"},
                            {"child", "arm"},
                            {"axis", {0, 1, 0}}});
  expect_refusal(loop, swing(0), "a closed loop is no tree");
}

// Oracle: Ohm's law and the contract's battery. All drives off: nothing sags.
TEST_F(HopperCheck, SharesTheRobotsBattery) {
  json robot = crane_with_wrist(0.5);
  robot["battery"] = {{"series_cells", 16},
                      {"parallel_cells", 4},
                      {"cell_open_circuit_V", 4.2},
                      {"cell_resistance_ohm", 0.015}};
  std::string motion =
      "time_s,base_x_position_m,base_z_position_m,base_pitch_position_rad,elbow_position_rad,"
      "wrist_position_rad\n";
  for (int i = 0; i <= 100; ++i) motion += fmt::format("{},0,0,0,0,0\n", 0.01 * i);
  const json report = json::parse(check(robot, motion, {"--json"}).out);
  ASSERT_EQ(report["buses"].size(), 1u);
  const json& bus = report["buses"][0];
  // Holds 9.81 (0.5 + 0.5) Nm at the elbow, none at the wrist; R i^2 at 0.28 ohm, Kt 0.32, 20:1.
  const double current_A = 9.81 / (0.32 * 20);
  const double power_W = 0.28 * current_A * current_A;
  EXPECT_NEAR(bus["greatest_power_W"].get<double>(), power_W, 1e-6);
  const double resistance_ohm = 0.015 * 16 / 4;
  EXPECT_NEAR(bus["least_V"].get<double>(),
              0.5 * (67.2 + std::sqrt(67.2 * 67.2 - 4 * resistance_ohm * power_W)), 1e-9);
}

// Oracle: the same motion with its header: rows alone, times counted, say the same of it.
TEST_F(HopperCheck, ReadsRowsWithoutAHeader) {
  std::ifstream file(in_specs("trajectory/hopper_squat.csv"));
  std::string line, rows;
  while (std::getline(file, line)) {
    const bool is_row = !line.empty() && std::isdigit(static_cast<unsigned char>(line.front()));
    if (is_row) rows += line.substr(line.find(',') + 1) + "\n";
  }
  place_.write("rows.csv", rows);
  const std::string robot = in_specs("robot/hopper.json");
  const Outcome with =
      place_.run({"hopper", "check", robot, in_specs("trajectory/hopper_squat.csv"), "--json"});
  const Outcome without = place_.run({"hopper", "check", robot, "rows.csv", "--fps", "500",
                                      "--order", "base,quaternion_wxyz,joints", "--json"});
  ASSERT_EQ(without.exit_code, with.exit_code) << without.err;
  const json one = json::parse(with.out), other = json::parse(without.out);
  EXPECT_EQ(other.at("verdict"), one.at("verdict"));
  EXPECT_EQ(other.at("joints"), one.at("joints"));
}

}  // namespace
}  // namespace torquewright::cli_test
