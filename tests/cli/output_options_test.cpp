// SPDX-License-Identifier: Apache-2.0
// Where results go (docs/decisions/0024). The oracle of each file is what the same command prints
// to standard output, whose content other tests hold against theirs.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/cli/workplace.hpp"

namespace torquewright::cli_test {
namespace {

using nlohmann::json;
using Words = std::vector<std::string>;

const std::string kWrittenKnee = in_repository("specs/actuator/d151_knee.json");
const std::string kStronger = in_repository("specs/actuator/d110a_ankle.json");
const std::string kMotion = in_repository("specs/trajectory/knee_extension.csv");

Words with_words(Words words, const Words& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

struct Reporting {
  Words command;
  int exit_code;
};

/// Commands whose document is JSON and whose standard output is for people.
std::vector<Reporting> reporting() {
  return {
      {{"gearbox", "optimize", "knee.json"}, 0},
      {{"gearbox", "evaluate", "knee.json", "--teeth", "44,44,32"}, 0},
      {{"gearbox", "verify", in_repository("specs/gearbox/d151_knee_result.json")}, 0},
      {{"gearbox", "strength", in_repository("specs/gearbox/d110a_strength.json"), "--torque", "1"},
       0},
      {{"actuator", "lint", kWrittenKnee}, 0},
      {{"actuator", "mor", kWrittenKnee, "--need", "200@10"}, 1},
      {{"actuator", "mor", kWrittenKnee, "--ratio", "4:40"}, 0},
      {{"actuator", "mor", kWrittenKnee, "--compare", kStronger}, 0},
      {{"actuator", "check", kMotion, "--joint", "knee=" + kWrittenKnee}, 0}};
}

std::string name_of(const Words& command) { return command[0] + " " + command[1]; }

class OutputOptions : public testing::Test {
 protected:
  OutputOptions() { place.write("knee.json", knee()); }
  Workplace place;
};

TEST_F(OutputOptions, DocumentToItsFileAndTheTextForPeopleAsEver) {
  for (const Reporting& each : reporting()) {
    const Outcome text = place.run(each.command);
    const Outcome document = place.run(with_words(each.command, {"--json"}));
    const Outcome both = place.run(with_words(each.command, {"-o", "it.json"}));
    EXPECT_EQ(both.err, "") << name_of(each.command);
    EXPECT_EQ(both.exit_code, text.exit_code) << name_of(each.command);
    EXPECT_EQ(both.out, text.out) << name_of(each.command);
    EXPECT_EQ(place.text("it.json"), document.out) << name_of(each.command);
    EXPECT_TRUE(json::accept(place.text("it.json"))) << name_of(each.command);
  }
}

TEST_F(OutputOptions, ADashIsStandardOutputWithoutTheText) {
  for (const Reporting& each : reporting()) {
    const Outcome document = place.run(with_words(each.command, {"--json"}));
    const Outcome dash = place.run(with_words(each.command, {"-o", "-"}));
    EXPECT_EQ(dash.out, document.out) << name_of(each.command);
    EXPECT_EQ(dash.err, "") << name_of(each.command);
    EXPECT_EQ(dash.exit_code, document.exit_code) << name_of(each.command);
  }
  EXPECT_FALSE(place.has("-"));
}

TEST_F(OutputOptions, ADashIsStandardOutputOfWhatIsMadeToo) {
  const std::vector<Words> makers = {
      {"actuator", "mor", kWrittenKnee, "--table"},
      {"robot", "import", in_repository("specs/robot/rabbit.urdf")},
      {"robot", "export", in_repository("specs/robot/rabbit.json"), "--format", "urdf"},
      {"identify", "simulate", kWrittenKnee, "--rig", in_repository("specs/rig/knee_sweep.json"),
       "--excitation", in_repository("specs/excitation/knee_sweep.csv")},
      {"init", "rig"},
      {"schema", "rig"},
      {"man", "init"},
      {"completion", "bash"}};
  for (const Words& command : makers) {
    const Outcome printed = place.run(command);
    const Outcome dash = place.run(with_words(command, {"-o", "-"}));
    EXPECT_EQ(dash.out, printed.out) << name_of(command);
    EXPECT_EQ(dash.err, printed.err) << name_of(command);  // notes of an import
    EXPECT_EQ(dash.exit_code, 0) << name_of(command);
  }
  EXPECT_EQ(place.files().size(), 1u);  // the problem alone
}

TEST_F(OutputOptions, ADashPrintsWhatIsDrawnAndExported) {
  const Outcome drawing = place.run({"gearbox", "optimize", "knee.json", "--draw", "-"});
  EXPECT_TRUE(drawing.out.starts_with("<")) << drawing.out.substr(0, 80);
  EXPECT_NE(drawing.out.find("</svg>"), std::string::npos);
  EXPECT_EQ(drawing.out.find("optimal: proved"), std::string::npos);
  const Words exported{"actuator", "mor", kWrittenKnee, "--format", "mujoco"};
  EXPECT_EQ(place.run(with_words(exported, {"--export", "-"})).out, place.run(exported).out);
}

TEST_F(OutputOptions, ADashWhereItCannotBeIsRefusedByName) {
  struct Refused {
    Words command;
    std::string said;
  };
  const std::vector<Refused> all = {
      {{"gearbox", "optimize", "knee.json", "-o", "-", "--draw", "-"},
       "-: standard output takes one of the files that were asked for\n"},
      {{"identify", "import", "moteus", in_repository("specs/log/wheel_moteus.csv"), "-o", "-"},
       "command line: --output: \"-\" is not a file but standard output"},
      {{"hopper", "flip", in_repository("specs/robot/hopper.json"), "-o", "-", "--json"},
       "--json: standard output takes the motion of -o -\n"}};
  for (const Refused& each : all) {
    const Outcome outcome = place.run(each.command);
    EXPECT_EQ(outcome.exit_code, 2) << name_of(each.command);
    EXPECT_EQ(outcome.out, "");
    EXPECT_NE(outcome.err.find(each.said), std::string::npos) << outcome.err;
  }
  EXPECT_EQ(place.files().size(), 1u);
}

TEST_F(OutputOptions, AFileThatIsCalledADashHasAFolder) {
  ASSERT_EQ(place.run({"schema", "rig", "-o", "./-"}).exit_code, 0);
  EXPECT_EQ(place.text("-"), place.run({"schema", "rig"}).out);
}

TEST_F(OutputOptions, ExportStandsBesideTheDocument) {
  const Words command{"actuator", "mor", kWrittenKnee, "--format", "mujoco"};
  const Outcome both = place.run(with_words(command, {"--export", "k.xml", "-o", "k.json"}));
  EXPECT_EQ(both.exit_code, 0) << both.err;
  EXPECT_EQ(both.out + both.err, "");
  EXPECT_EQ(place.text("k.xml"), place.run(command).out);
  EXPECT_EQ(place.text("k.json"), place.run(with_words(command, {"--json"})).out);
  EXPECT_EQ(json::parse(place.text("k.json"))["kind"], "simulator_file");
  const Outcome table =
      place.run({"actuator", "mor", kWrittenKnee, "--format", "csv", "--export", "k.csv"});
  EXPECT_EQ(table.exit_code, 2);
  EXPECT_EQ(table.err, "--export: --format csv is no simulator's; the table goes to -o\n");
}

// One sentence that names the new spelling, which then gives the same file and says nothing.
TEST_F(OutputOptions, OldSpellingsWorkAndNameTheNewOnes) {
  const Words bench{"identify",   in_repository("specs/log/bench_as_built.csv"),
                    "--rig",      in_repository("specs/log/bench_rig.json"),
                    "--actuator", in_repository("specs/log/bench_actuator.json")};
  const Words fit{"hopper",
                  "calibrate",
                  in_repository("specs/robot/hopper.json"),
                  "--target",
                  "cam=6.0",
                  "--target",
                  "cav=7.4:10.6",
                  "--free",
                  "/postures/takeoff/knee",
                  "--free",
                  "/postures/tuck/knee",
                  "--tolerance",
                  "0.5"};
  struct Old {
    Words command;
    std::string file, what, instead;
  };
  const std::vector<Old> all = {{bench, "old.json", "the refined actuator", "--refined"},
                                {fit, "old.json", "the robot with the fitted values", "--refined"},
                                {{"actuator", "mor", kWrittenKnee, "--format", "mujoco"},
                                 "old.xml",
                                 "the simulator's file",
                                 "--export"}};
  for (const Old& each : all) {
    const Outcome old = place.run(with_words(each.command, {"-o", each.file}));
    const std::string before = place.text(each.file);
    EXPECT_EQ(old.err, "note: -o " + each.file + " writes " + each.what +
                           " in this version only; from the next one on, write " + each.instead +
                           " " + each.file + "\n");
    fs::remove(place.path(each.file));
    const Outcome now = place.run(with_words(each.command, {each.instead, each.file}));
    EXPECT_EQ(now.exit_code, old.exit_code);
    EXPECT_EQ(now.err, "");
    EXPECT_EQ(now.out, old.out);
    EXPECT_EQ(place.text(each.file), before);
    EXPECT_GT(before.size(), 100u);
  }
  const Words check{"actuator", "check", kMotion, "--joint", "knee=" + kWrittenKnee};
  const Outcome text = place.run(with_words(check, {"-o", "report.txt"}));
  EXPECT_EQ(text.err,
            "note: -o report.txt writes the text for people in this version only; from the next "
            "one on, write > report.txt\n");
  EXPECT_EQ(text.out, "");
  EXPECT_EQ(place.text("report.txt"), place.run(check).out);
}

// Where the refined actuator has its own option, -o is the report already.
TEST_F(OutputOptions, RefinedStandsBesideTheReport) {
  const Words bench{"identify",   in_repository("specs/log/bench_as_built.csv"),
                    "--rig",      in_repository("specs/log/bench_rig.json"),
                    "--actuator", in_repository("specs/log/bench_actuator.json")};
  const Outcome both =
      place.run(with_words(bench, {"--refined", "refined.json", "-o", "report.json"}));
  EXPECT_EQ(both.err, "");
  EXPECT_TRUE(both.out.find("explained") != std::string::npos) << both.out;
  EXPECT_EQ(place.text("report.json"), place.run(with_words(bench, {"--json"})).out);
  EXPECT_EQ(json::parse(place.text("refined.json"))["kind"], "actuator");
  EXPECT_EQ(place.run(with_words(bench, {"-o", "-"})).out, place.text("report.json"));
}

}  // namespace
}  // namespace torquewright::cli_test
