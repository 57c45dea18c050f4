// SPDX-License-Identifier: Apache-2.0
// Ctrl-C ends a search with what it has.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/cli/workplace.hpp"

namespace torquewright::cli_test {
namespace {

using nlohmann::json;
using std::chrono::milliseconds;

/// Keeps the search busy for minutes: a large bore, a wide tolerance, an objective with roots.
std::string long_search() {
  return with(with(with(knee_with("79.4", "2000"), "\"module_mm\": 0.6", "\"module_mm\": 1"),
                   "\"ratio_tolerance\": 0", "\"ratio_tolerance\": 0.05"),
              "paper_cost", "forward_efficiency");
}

Outcome interrupted(Workplace& place, const std::vector<std::string>& more) {
  place.write("long.json", long_search());
  place.here.interrupt_after = milliseconds(1000);
  std::vector<std::string> command = {"gearbox", "optimize", "long.json"};
  command.insert(command.end(), more.begin(), more.end());
  const Outcome outcome = place.run(command);
  place.here.interrupt_after.reset();
  return outcome;
}

TEST(Interrupt, EndsASearchWithTheBestSoFarAndItsBound) {
  Workplace place;
  const Outcome outcome = interrupted(place, {"--json", "-o", "result.json", "--draw", "best.svg"});
  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_EQ(outcome.err, "");
  EXPECT_EQ(outcome.out, place.text("result.json"));
  const json result = json::parse(outcome.out);
  EXPECT_EQ(result["status"], "limit");
  ASSERT_FALSE(result["designs"].empty());
  EXPECT_EQ(result["objective"], result["designs"][0]["objective"]);
  EXPECT_GE(result["bound"], result["objective"]);
  EXPECT_TRUE(place.text("best.svg").ends_with("</svg>\n"));
  const Outcome verdict = place.run({"gearbox", "verify", "result.json"});
  EXPECT_EQ(verdict.exit_code, 3) << verdict.out;
}

TEST(Interrupt, IsSaidInTheText) {
  Workplace place;
  const Outcome outcome = interrupted(place, {"--verify"});
  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_EQ(outcome.err, "");
  EXPECT_TRUE(outcome.out.starts_with("limit: the search was ended;")) << outcome.out;
  EXPECT_NE(outcome.out.find("\nBound that nothing beats: "), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("accepted"), std::string::npos) << outcome.out;
}

}  // namespace
}  // namespace torquewright::cli_test
