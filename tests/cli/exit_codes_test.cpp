// SPDX-License-Identifier: Apache-2.0
// What a caller may rely on: exit codes, what goes to which stream, and the same bytes every time.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/cli/workplace.hpp"

namespace torquewright::cli_test {
namespace {

using nlohmann::json;

TEST(ExitCode, IsZeroForTheBestGearbox) {
  const Workplace place;
  place.write("knee.json", knee());
  const Outcome outcome = place.run({"gearbox", "optimize", "knee.json", "--verify"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.err, "");
  EXPECT_TRUE(
      outcome.out.starts_with("optimal: proved, nothing is better.\n"
                              "Held fixed: no profile shift, one module for both layers, "
                              "rings coaxial by their teeth.\n"
                              "1. sun 44, planet_1 44, planet_2 32, fixed_ring 132, "
                              "output_ring 120; 4 planets, module 0.6 mm\n"))
      << outcome.out;
  EXPECT_TRUE(outcome.out.find("\naccepted: 44/44/32/132/120 with 4 planets") != std::string::npos)
      << outcome.out;
}

TEST(ExitCode, IsOneWhereNoDesignIsFeasible) {
  const Workplace place;
  place.write("tight.json", tight_knee());
  const Outcome outcome = place.run({"gearbox", "optimize", "tight.json"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_EQ(outcome.err, "");
  EXPECT_TRUE(outcome.out.starts_with("infeasible: ")) << outcome.out;
  EXPECT_NE(outcome.out.find("min_carrier_clearance_rad = 0.4 rad is too much: 0.2617 rad would "
                             "do"),
            std::string::npos)
      << outcome.out;
}

TEST(ExitCode, IsTwoForBadInput) {
  const Workplace place;
  const Outcome outcome = place.run({"gearbox", "optimize", "absent.json"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(outcome.err, "absent.json: no such file\n");
}

TEST(ExitCode, IsThreeWhereALimitWasReached) {
  const Workplace place;
  place.write("knee.json", knee());
  const Outcome outcome =
      place.run({"gearbox", "optimize", "knee.json", "--max-nodes", "1", "--verify"});
  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_EQ(outcome.err, "");
  EXPECT_TRUE(outcome.out.starts_with("limit: ")) << outcome.out;
  EXPECT_NE(outcome.out.find("Bound that nothing beats: "), std::string::npos) << outcome.out;
}

TEST(Evaluate, PassesTheD151sGearbox) {
  const Workplace place;
  place.write("knee.json", knee());
  const Outcome outcome =
      place.run({"gearbox", "evaluate", "knee.json", "--teeth", "44,44,32", "--draw", "knee.svg"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.err, "");
  EXPECT_TRUE(place.text("knee.svg").ends_with("</svg>\n"));
}

TEST(Evaluate, FailsABadDesignWithASentence) {
  const Workplace place;
  place.write("knee.json", knee());
  // 45 + 44 = 89 teeth make 178, which four planets cannot share.
  const Outcome outcome = place.run({"gearbox", "evaluate", "knee.json", "--teeth", "45,44,32"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_EQ(outcome.err, "");
  EXPECT_NE(outcome.out.find("equal_spacing: "), std::string::npos) << outcome.out;
}

TEST(Json, IsTheSameOnStdoutAndInTheFile) {
  const Workplace place;
  place.write("knee.json", knee());
  const std::vector<std::vector<std::string>> commands = {
      {"gearbox", "optimize", "knee.json"},
      {"gearbox", "evaluate", "knee.json", "--teeth", "44,44,32"}};
  for (std::vector<std::string> command : commands) {
    command.insert(command.end(), {"--json", "-o", "result.json"});
    const Outcome outcome = place.run(command);
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_EQ(outcome.err, "");
    EXPECT_EQ(outcome.out, place.text("result.json"));
    EXPECT_EQ(json::parse(outcome.out)["kind"], "gearbox_result");
  }
  place.run({"gearbox", "optimize", "knee.json", "-o", "result.json"});
  const Outcome verdict = place.run({"gearbox", "verify", "result.json", "--json"});
  EXPECT_EQ(json::parse(verdict.out)["accepted"], true);
}

TEST(Result, HasTheSameBytesEveryTime) {
  const Workplace place;
  place.write("choices.json", text_of(in_repository("specs/gearbox/d110a_ankle.json")));
  const std::vector<std::string> command = {"gearbox", "optimize", "choices.json", "--json",
                                            "--draw",  "x.svg",    "--top",        "3"};
  const Outcome first = place.run(command);
  const std::string first_drawing = place.text("x.svg");
  const Outcome second = place.run(command);
  EXPECT_EQ(first.exit_code, 0);
  EXPECT_EQ(first.out, second.out);
  EXPECT_EQ(first_drawing, place.text("x.svg"));
}

TEST(Result, StatesSecondsOnlyWhereAskedFor) {
  const Workplace place;
  place.write("knee.json", knee());
  const std::vector<std::string> command = {"gearbox", "optimize", "knee.json", "--json"};
  std::vector<std::string> timed = command;
  timed.push_back("--timing");
  EXPECT_FALSE(json::parse(place.run(command).out)["search"].contains("seconds"));
  EXPECT_TRUE(json::parse(place.run(timed).out)["search"].contains("seconds"));
}

TEST(Version, IsThatOfTheBuild) {
  const Outcome outcome = run({"--version"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.out, TORQUEWRIGHT_VERSION "\n");
  EXPECT_EQ(outcome.err, "");
}

}  // namespace
}  // namespace torquewright::cli_test
