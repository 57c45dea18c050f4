// SPDX-License-Identifier: Apache-2.0
#include "io/text/nearest.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace torquewright::io {
namespace {

// Oracle: textbook examples, counted by hand.
TEST(EditDistance, CountsEdits) {
  EXPECT_EQ(edit_distance("", ""), 0u);
  EXPECT_EQ(edit_distance("", "abc"), 3u);
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3u);
  EXPECT_EQ(edit_distance("sun", "sunn"), 1u);
  EXPECT_EQ(edit_distance("sun", "snu"), 1u);  // a swap
  EXPECT_EQ(edit_distance("abc", "cab"), 2u);
}

TEST(Nearest, TakesTheFewestEditsAndTheFirstOfEquals) {
  const std::vector<std::string> known = {"planet", "planet_1", "planet_2", "sun"};
  EXPECT_EQ(nearest("sunn", known), "sun");
  EXPECT_EQ(nearest("planet1", known), "planet");
  EXPECT_EQ(nearest("plnaet_2", known), "planet_2");
}

// Just inside and just outside a third of the longer word's letters.
TEST(Nearest, FindsNoneTooFarOff) {
  const std::vector<std::string> known = {"abcdef"};
  EXPECT_EQ(nearest("abcdxy", known), "abcdef");
  EXPECT_EQ(nearest("abcxyz", known), std::nullopt);
  EXPECT_EQ(nearest("", known), std::nullopt);
  EXPECT_EQ(nearest("x", std::vector<std::string>{}), std::nullopt);
  EXPECT_EQ(nearest(std::string(10000000, 'a'), known), std::nullopt);
}

}  // namespace
}  // namespace torquewright::io
