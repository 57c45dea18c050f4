// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "gearbox/verification/verification_json.hpp"
#include "tests/gearbox/verification/real_result.hpp"

namespace torquewright::gearbox::verification_test {
namespace {

TEST(Verification, SaysWhatIsProved) {
  const test::ScratchFolder folder;
  const Verification found = verified(real_result(folder, knee_with(), Json::object()));
  EXPECT_TRUE(found.is_accepted);
  EXPECT_EQ(
      found.claim,
      "44/44/32/132/120 with 4 planets, module 0.6 mm is the best: no other design that satisfies "
      "all constraints reaches its paper_cost 17360.112.");
  EXPECT_GT(found.counts.nodes, 0);
  EXPECT_EQ(found.checked.size(), 3U);
}

TEST(Verification, NamesTheFirstNumberThatIsNotSo) {
  const test::ScratchFolder folder;
  Json result = real_result(folder, knee_with(), Json::object());
  result["designs"][0]["gears"][1]["tip_diameter_mm"] = 30;
  const Verification found = verified(result);
  EXPECT_TRUE(found.is_proved);
  EXPECT_FALSE(found.is_accepted);
  ASSERT_EQ(found.faults.size(), 1U);
  EXPECT_EQ(found.faults[0].find("/designs/0/gears/1/tip_diameter_mm: is 30, expected 27."), 0U)
      << found.faults[0];
}

TEST(Verification, ComparesTheProblemWithItsFile) {
  const test::ScratchFolder folder;
  Json result = real_result(folder, knee_with(), Json::object());
  result["problem"]["name"] = "another knee";
  Verification found = verified(result);
  ASSERT_EQ(found.faults.size(), 1U);
  EXPECT_EQ(
      found.faults[0].find("/problem/name: is \"another knee\", expected \"D151 knee\" as in "),
      0U);

  result["problem"]["name"] = "D151 knee";
  ASSERT_TRUE(verified(result).is_accepted);
  std::ofstream(result["inputs"][0]["path"].get<std::string>(), std::ios::app) << "\n";
  found = verified(result);
  ASSERT_EQ(found.faults.size(), 1U);
  EXPECT_EQ(found.faults[0].find("/inputs/0/sha256: is not that of "), 0U);

  std::filesystem::remove(result["inputs"][0]["path"].get<std::string>());
  found = verified(result);
  EXPECT_TRUE(found.is_accepted);
  ASSERT_EQ(found.unchecked.size(), 1U);
  EXPECT_NE(found.unchecked[0].find("is not here"), std::string::npos);
}

// A search that was ended knows the gap to its bound as a share of the greater of the two, or knows
// no bound at all.
TEST(Verification, AcceptsWhatALimitedSearchSays) {
  const test::ScratchFolder folder;
  for (const char* objective : {"paper_cost", "forward_efficiency", "backward_efficiency"}) {
    Json problem = knee_with({{"objective", objective},
                              {"ratio_tolerance", 0.01},
                              {"min_teeth", {{"sun", 20}, {"planet_1", 20}, {"planet_2", 16}}}});
    for (const int nodes : {1, 5, 10, 20}) {
      const Json result = real_result(folder, problem, {{"max_nodes", nodes}});
      const Verification found = verified(result);
      EXPECT_TRUE(found.is_accepted) << objective << " " << nodes << " " << found.faults.front();
      EXPECT_EQ(found.is_undecided, result["status"] == "limit");
    }
  }
}

}  // namespace
}  // namespace torquewright::gearbox::verification_test
