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

Outcome interrupted(Workplace& place, const std::vector<std::string>& command, milliseconds after) {
  place.here.interrupt_after = after;
  const Outcome outcome = place.run(command);
  place.here.interrupt_after.reset();
  return outcome;
}

Outcome interrupted(Workplace& place, const std::vector<std::string>& more) {
  place.write("long.json", long_search());
  std::vector<std::string> command = {"gearbox", "optimize", "long.json"};
  command.insert(command.end(), more.begin(), more.end());
  return interrupted(place, command, milliseconds(1000));
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

// A job in the background that its shell lets ignore it is not for the terminal's Ctrl-C.
TEST(Interrupt, EndsNothingThatIgnoresIt) {
  Workplace place;
  place.write("long.json", long_search());
  const std::vector<std::string> search{"gearbox",     "optimize", "long.json",
                                        "--max-nodes", "2000",     "--json"};
  place.here.ignores_interrupt = true;
  place.here.signal = Signal{SIGINT, milliseconds(50)};
  EXPECT_EQ(json::parse(place.run(search).out)["search"]["nodes"], 2000);
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

TEST(Interrupt, EndsARankingThatIsNotSettled) {
  Workplace place;
  place.write("long.json", long_search());
  const Outcome outcome =
      interrupted(place, {"gearbox", "evaluate", "long.json", "--teeth", "44,44,32", "--rank"},
                  milliseconds(500));
  EXPECT_EQ(outcome.exit_code, 3) << outcome.err;
  EXPECT_NE(outcome.out.find("\nRank not settled: "), std::string::npos) << outcome.out;
}

TEST(Interrupt, EndsACheckOfAProof) {
  Workplace place;
  EXPECT_EQ(interrupted(place, {"-o", "result.json"}).exit_code, 3);
  const Outcome outcome =
      interrupted(place, {"gearbox", "verify", "result.json"}, milliseconds(50));
  EXPECT_EQ(outcome.exit_code, 3) << outcome.out;
  EXPECT_TRUE(outcome.out.starts_with("ended: only ")) << outcome.out;
}

TEST(TimeLimit, EndsASearchLikeCtrlC) {
  Workplace place;
  place.write("long.json", long_search());
  const Outcome outcome = place.run(
      {"gearbox", "optimize", "long.json", "--time-limit", "0.3", "-o", "result.json", "--json"});
  EXPECT_EQ(outcome.exit_code, 3) << outcome.err;
  const json result = json::parse(place.text("result.json"));
  EXPECT_EQ(result["status"], "limit");
  EXPECT_EQ(result["options"]["time_limit_s"], 0.3);
  EXPECT_LE(result["bound"], 1.0);  // no efficiency exceeds 1
  EXPECT_EQ(place.run({"gearbox", "verify", "result.json"}).exit_code, 3);
}

// One design's numbers do not wait for a rank among many.
TEST(Rank, IsLeftOutWhereManyDesignsWouldHaveToBeSeen) {
  Workplace place;
  place.write("long.json", long_search());
  const Outcome outcome =
      place.run({"gearbox", "evaluate", "long.json", "--teeth", "44,44,32", "-o", "one.json"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("\nRank not settled: "), std::string::npos) << outcome.out;
  EXPECT_TRUE(json::parse(place.text("one.json"))["rank"].is_null());
}

}  // namespace
}  // namespace torquewright::cli_test
