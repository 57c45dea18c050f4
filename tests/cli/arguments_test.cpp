// SPDX-License-Identifier: Apache-2.0
// Command lines that are not understood: exit 2, one line that says what and what is allowed.
#include <gtest/gtest.h>

#include "tests/cli/workplace.hpp"

namespace torquewright::cli_test {
namespace {

struct BadArguments {
  std::vector<std::string> arguments;
  std::string refusal;  ///< Before "; --help shows what is allowed" where that follows.
};

void PrintTo(const BadArguments& bad, std::ostream* stream) { *stream << bad.refusal; }

const std::vector<std::string> kOptimize = {"gearbox", "optimize", "knee.json"};
const std::vector<std::string> kEvaluate = {"gearbox", "evaluate", "knee.json"};

std::vector<std::string> after(std::vector<std::string> command,
                               const std::vector<std::string>& more) {
  command.insert(command.end(), more.begin(), more.end());
  return command;
}

std::vector<BadArguments> bad_arguments() {
  const auto optimize = [](const std::vector<std::string>& more) { return after(kOptimize, more); };
  const auto teeth = [](const std::string& list) { return after(kEvaluate, {"--teeth", list}); };
  const std::string in_teeth = "command line: --teeth: ";
  return {
      {{"gearbx"}, "command line: unknown command \"gearbx\"; did you mean gearbox?"},
      {{"gearbox", "optimise"},
       "command line: unknown command \"optimise\"; did you mean gearbox optimize?"},
      {{"mor", "knee.json"}, "command line: unknown command \"mor\"; did you mean actuator mor?"},
      {{"hopper", "xyzzy"},
       "command line: unknown command \"xyzzy\"; there are check, flip, replay, train, calibrate"},
      {{"help", "gearbx"}, "command line: unknown command \"gearbx\"; did you mean gearbox?"},
      {{"actuator", "mor", "a.json", "--bus-votage", "3"},
       "command line: unknown option --bus-votage of actuator mor; did you mean --bus-voltage?"},
      {{"actuator", "mor", "a.json", "--a-speed=3"},
       "command line: unknown option --a-speed of actuator mor; did you mean --at-speed?"},
      {{"hopper", "check", "a.json", "b.csv", "--trials", "3"},
       "command line: unknown option --trials of hopper check; it is one of hopper flip, hopper "
       "replay or robot replay"},
      {{"actuator", "mor", "a.json", "--side", "jont"},
       "command line: --side: \"jont\" is not one of joint, motor; did you mean joint?"},
      {{"actuator", "mor", "a.json", "--for", "mjlab", "--format=mujoco"},
       "command line: --for and --format are one option; give one of them"},
      {{"actuator", "mor", "a.json", "--side", "joint", "--side", "motor"},
       "command line: --side is given twice; give one"},
      {{"robot", "export", "a.json"},
       "command line: --format is required: mjcf, playground, urdf, gazebo, drake, genesis, "
       "pybullet, isaac-gym, isaac-lab, isaac-lab-remotized, mjlab, newton or isaac-lab-2.3"},
      {{"gearbox", "optimize"}, "command line: problem is required"},
      {optimize({"other.json"}),
       "command line: The following argument was not expected: other.json; it is torquewright "
       "gearbox optimize [OPTIONS] problem"},
      {optimize({"--nonsense"}), "command line: unknown option --nonsense of gearbox optimize"},
      {optimize({"--relaxation", "often"}),
       "command line: --relaxation: \"often\" is not one of auto, always, never"},
      {after({"gearbox", "optimize", "efficient.json"}, {"--relaxation", "always"}),
       "--relaxation: \"always\" cannot help with the objective forward_efficiency, of which no "
       "convex bound is known; \"auto\" and \"never\" search by intervals"},
      {{"actuator", "mor", "a.json", "-o", "--json"},
       "command line: --output: its value is missing, --json is an option; --output=--json would "
       "take it as one"},
      {{"gearbox", "strength", "a.json", "--torque", "17,"},
       "command line: --torque: \"17,\" has a blank place in its list"},
      {{"gearbox", "evaluate", "a.json", "--teeth", "9,9", "--profile-shift=,0.1,0"},
       "command line: --profile-shift: \",0.1,0\" has a blank place in its list"},
      {{"actuator", "mor", "a.json", "--ratio", " "}, "command line: --ratio: \" \" is blank"},
      {optimize({"--top", "0"}),
       "command line: --top: \"0\" is not a whole number from 1 to 1000000"},
      {optimize({"--top", "-1"}),
       "command line: --top: \"-1\" is not a whole number from 1 to 1000000"},
      {optimize({"--top", "1000000000"}),
       "command line: --top: \"1000000000\" is not a whole number from 1 to 1000000"},
      {optimize({"--top", "two\nlines"}),
       "command line: --top: \"two\\u000alines\" is not a whole number from 1 to 1000000"},
      {optimize({"--max-nodes", "0"}),
       "command line: --max-nodes: \"0\" is not a whole number from 1 to 1152921504606846976"},
      {optimize({"-o", ""}), "command line: --output: a file's name is missing"},
      {kEvaluate, "command line: --teeth is required"},
      {teeth("44,44"),
       "knee.json: --teeth has 2 numbers; 3k takes 3 or 5: "
       "sun,planet_1,planet_2,fixed_ring,output_ring"},
      {teeth("44,44,32,132"),
       "knee.json: --teeth has 4 numbers; 3k takes 3 or 5: "
       "sun,planet_1,planet_2,fixed_ring,output_ring"},
      {teeth("a,b,c"), in_teeth + "\"a\" is not a whole number from 1 to 1000000"},
      {teeth("1e9,44,32"), in_teeth + "\"1e9\" is not a whole number from 1 to 1000000"},
      {teeth("-44,44,32"), in_teeth + "\"-44\" is not a whole number from 1 to 1000000"},
      {teeth("44,44,0"), in_teeth + "\"0\" is not a whole number from 1 to 1000000"},
      {teeth("44,44,32.5"), in_teeth + "\"32.5\" is not a whole number from 1 to 1000000"},
      {teeth("99999999999999999999,44,32"),
       in_teeth + "\"99999999999999999999\" is not a whole number from 1 to 1000000"},
      {teeth(""), in_teeth + "\"\" is not a whole number from 1 to 1000000"},
      // 36 teeth to a reader of octal numbers, 48 to one of hexadecimal ones.
      {teeth("044,44,32"), in_teeth + "\"044\" is not a whole number from 1 to 1000000"},
      {teeth("0x30,44,32"), in_teeth + "\"0x30\" is not a whole number from 1 to 1000000"},
      {after(teeth("44,44,32"), {"--module", "0x1"}),
       "command line: --module: \"0x1\" is not a number from 0.05 to 25"},
      // What would move up into the gap.
      {teeth("44,,44,32"), in_teeth + "\"44,,44,32\" has a blank place in its list"},
      {teeth(",44,44,32"), in_teeth + "\",44,44,32\" has a blank place in its list"},
      {after(kEvaluate, {"--teeth=44,44,32,"}),
       in_teeth + "\"44,44,32,\" has a blank place in its list"},
      {{"actuator", "mor", "a.json", "--json", "--at-speed", "1", "2,,3"},
       "command line: --at-speed: \"2,,3\" has a blank place in its list"},
      {{"identify", "plan", "a.json", "--rig", "r.json", "--separate", "a,,b"},
       "command line: --separate: \"a,,b\" has a blank place in its list"},
      {{"hopper", "flip", "robot.json", "--contacts", "flat,,flight"},
       "command line: --contacts: \"flat,,flight\" has a blank place in its list"},
      {{"gearbox", "strength", "result.json", "--face-width", ",8"},
       "command line: --face-width: \",8\" has a blank place in its list"},
      // Unset variables of a script.
      {{"actuator", "mor", "a.json", "--bus-voltage=", "--at-speed", "0"},
       "command line: --bus-voltage: \"\" is blank"},
      {{"actuator", "mor", "a.json", "--need", ""}, "command line: --need: \"\" is blank"},
      {{"actuator", "mor", "a.json", "--ratio", ""}, "command line: --ratio: \"\" is blank"},
      {{"actuator", "mor", "a.json", "--compare", ""}, "command line: --compare: \"\" is blank"},
      {{"hopper", "check", "a.json", "m.csv", "--candidates", ""},
       "command line: --candidates: \"\" is blank"},
      {{"hopper", "check", "a.json", "m.csv", "--ratios", ""},
       "command line: --ratios: \"\" is blank"},
      {{"hopper", "flip", "a.json", "--warm", ""}, "command line: --warm: \"\" is blank"},
      {{"robot", "import", "a.urdf", "--body", ""}, "command line: --body: \"\" is blank"},
      {{"identify", "a.csv", "--as", ""}, "command line: --as: \"\" is blank"},
      {{"identify", "a.csv", "--rig", "r.json", "--actuator", "a.json", "--as", "bam",
        "--empirical"},
       "command line: --empirical: adds a table to the report, in whose place --as prints numbers; "
       "allowed beside it with --output or --report"},
      {{"identify", "import", "moteus", "a.csv", "--units", ""},
       "command line: --units: \"\" is blank"},
      {{"actuator", "mor", ""}, "command line: actuator: \"\" is blank"},
      // The inner command works in the outer one's place.
      {{"identify", "-o", "x.json", "residual", "a.csv"},
       "command line: --output x.json stands before residual, which would not get it; write it "
       "behind residual"},
      {{"identify", "--json", "residual", "a.csv"},
       "command line: --json stands before residual, which would not get it; write it behind "
       "residual"},
      {{"identify", "a.csv", "residual", "b.csv"},
       "command line: \"a.csv\" stands before residual, which would not get it; write it behind "
       "residual"},
      {{"identify", "--report", "x.html", "residual", "a.csv"},
       "command line: --report x.html stands before residual, which takes no such thing"},
      {{"identify", "--only", "coulomb_friction", "residual", "a.csv"},
       "command line: --only coulomb_friction stands before residual, which takes no such thing"},
      {{"actuator", "mor", "a.json", "--compare", "b.json", "--plot", "x.svg", "--plot-voltage",
        "40"},
       "command line: --plot-voltage excludes --compare"},
      {{"actuator", "mor", "a.json", "--compare", "b.json", "--plot", "x.svg", "--plot-temperature",
        "300"},
       "command line: --plot-temperature excludes --compare"},
      {{"actuator", "mor", "a.json", "--plot", "x.svg", "--accuracy", "0.1"},
       "--accuracy: is of rows, and a picture alone has none; ask for them with --table, --json or "
       "-o"},
      {teeth("500000,500000,400000"),
       "knee.json: --teeth 500000,500000,400000 makes rings of "
       "500000,500000,400000,1500000,1400000 teeth; at most 1000000 are allowed"},
      {after(teeth("44,44,32"), {"--planet-count", "1"}),
       "command line: --planet-count: \"1\" is not a whole number from 2 to 20"},
      {after(teeth("44,44,32"), {"--module", "nan"}),
       "command line: --module: \"nan\" is not a number from 0.05 to 25"},
      {after(teeth("44,44,32"), {"--module", "1e400"}),
       "command line: --module: \"1e400\" is not a number from 0.05 to 25"},
  };
}

class Arguments : public testing::TestWithParam<BadArguments> {};

TEST_P(Arguments, AreRefusedInOneLine) {
  const Workplace place;
  place.write("knee.json", knee());
  place.write("efficient.json", knee_with("paper_cost", "forward_efficiency"));
  const Outcome outcome = place.run(GetParam().arguments);
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.out, "");
  const bool is_of_the_line = GetParam().refusal.starts_with("command line: ");
  EXPECT_EQ(outcome.err,
            GetParam().refusal + (is_of_the_line ? "; --help shows what is allowed\n" : "\n"));
}

INSTANTIATE_TEST_SUITE_P(Each, Arguments, testing::ValuesIn(bad_arguments()));

TEST(Arguments, MayComeInAnyOrder) {
  const Workplace place;
  place.write("knee.json", knee());
  EXPECT_EQ(place.run({"gearbox", "evaluate", "--teeth", "44,44,32", "knee.json"}).exit_code, 0);
}

}  // namespace
}  // namespace torquewright::cli_test
