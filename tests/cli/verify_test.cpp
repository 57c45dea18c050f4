// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/cli/workplace.hpp"

namespace torquewright::cli_test {
namespace {

using nlohmann::json;

TEST(Verify, AcceptsWhatOptimizeWroteForEveryExample) {
  const Workplace place;
  int problems = 0;
  for (const auto& entry : fs::directory_iterator(in_repository("specs/gearbox"))) {
    const json document = json::parse(text_of(entry.path()));
    if (document["kind"] != "gearbox_problem") continue;
    ++problems;
    const Outcome found =
        place.run({"gearbox", "optimize", entry.path(), "-o", "result.json", "--verify"});
    EXPECT_EQ(found.exit_code, 0) << entry.path() << found.out;
    const Outcome verdict = place.run({"gearbox", "verify", "result.json"});
    EXPECT_EQ(verdict.exit_code, 0) << entry.path() << verdict.out;
    EXPECT_EQ(verdict.err, "");
  }
  EXPECT_GE(problems, 5);
}

TEST(Verify, AcceptsAConflict) {
  const Workplace place;
  place.write("tight.json", tight_knee());
  EXPECT_EQ(place.run({"gearbox", "optimize", "tight.json", "-o", "result.json"}).exit_code, 1);
  EXPECT_EQ(place.run({"gearbox", "verify", "result.json"}).exit_code, 0);
}

TEST(Verify, IsUndecidedAboutALimit) {
  const Workplace place;
  place.write("knee.json", knee());
  place.run({"gearbox", "optimize", "knee.json", "--max-nodes", "1", "-o", "result.json"});
  const Outcome verdict = place.run({"gearbox", "verify", "result.json", "--json"});
  EXPECT_EQ(verdict.exit_code, 3);
  EXPECT_EQ(json::parse(verdict.out)["accepted"], true);
  EXPECT_EQ(json::parse(verdict.out)["undecided"], true);
}

TEST(Verify, FailsATamperedResult) {
  const Workplace place;
  const std::string honest = text_of(in_repository("specs/gearbox/d151_knee_result.json"));
  // Another optimum; a problem of which it is not the optimum; a leaf that is not empty.
  const std::vector<std::pair<std::string, std::string>> lies = {
      {"\"planet_2\": 32", "\"planet_2\": 33"},
      {"\"rotor_inner_diameter_mm\": 79.4", "\"rotor_inner_diameter_mm\": 99.4"},
      {"\"closed\": \"enumerated\"", "\"closed\": \"open\""},
  };
  for (const auto& [from, to] : lies) {
    place.write("lie.json", with(honest, from, to));
    const Outcome verdict = place.run({"gearbox", "verify", "lie.json"});
    EXPECT_EQ(verdict.exit_code, 1) << to;
    EXPECT_TRUE(verdict.out.starts_with("rejected: the result is not proved:\n  /")) << verdict.out;
    EXPECT_EQ(verdict.err, "");
  }
}

/// What verify says of a file, which has to be a refusal.
std::string refusal(const Workplace& place, const std::string& file) {
  const Outcome outcome = place.run({"gearbox", "verify", file});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.out, "");
  return outcome.err;
}

TEST(Verify, RefusesAnEvaluation) {
  const Workplace place;
  place.write("knee.json", knee());
  place.run({"gearbox", "evaluate", "knee.json", "--teeth", "44,44,32", "-o", "evaluation.json"});
  EXPECT_EQ(
      refusal(place, "evaluation.json"),
      "evaluation.json#/certificate: holds no claims: this is what `gearbox evaluate` says of "
      "one design; `gearbox verify` checks the proof in a result of `gearbox optimize`\n");
}

TEST(Verify, RefusesWhatIsNoResult) {
  const Workplace place;
  place.write("knee.json", knee());
  place.write("nonsense.json", "three gears\n");
  EXPECT_EQ(refusal(place, "knee.json"),
            "knee.json#/kind: \"gearbox_problem\" is not \"gearbox_result\"\n");
  EXPECT_EQ(refusal(place, "nonsense.json"),
            "nonsense.json: line 1, column 2: not JSON: invalid literal\n");
  EXPECT_EQ(refusal(place, "absent.json"), "absent.json: no such file\n");
}

TEST(Verify, RefusesAResultWithABadProblem) {
  const Workplace place;
  const std::string honest = text_of(in_repository("specs/gearbox/d151_knee_result.json"));
  place.write("bad.json",
              with(honest, "\"friction_coefficient\": 0.08", "\"friction_coefficient\": 8"));
  EXPECT_EQ(refusal(place, "bad.json"),
            "bad.json#/problem/friction_coefficient: 8 is outside [0, 0.9]\n");
}

}  // namespace
}  // namespace torquewright::cli_test
