// SPDX-License-Identifier: Apache-2.0
#include "gearbox/verification/difference_json.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace torquewright::gearbox {
namespace {

using Json = nlohmann::json;

void expect_difference(const Json& found, const Json& expected, const std::string& pointer,
                       const std::string& sentence) {
  const auto difference = first_difference(found, expected);
  ASSERT_TRUE(difference) << found << " " << expected;
  EXPECT_EQ(difference->pointer, pointer);
  EXPECT_EQ(difference->sentence, sentence);
}

TEST(FirstDifference, NamesPlaceAndValues) {
  const Json expected = {{"a", {1, 2, {{"b/c", "x"}}}}, {"d", nullptr}};
  EXPECT_FALSE(first_difference(expected, expected));
  Json found = expected;
  found["a"][2]["b/c"] = "y";
  expect_difference(found, expected, "/a/2/b~1c", "is \"y\", expected \"x\"");
  found = expected;
  found.erase("d");
  expect_difference(found, expected, "/d", "is missing, expected null");
  expect_difference(expected, found, "/d", "is no key here");
  found = expected;
  found["a"].push_back(4);
  expect_difference(found, expected, "/a", "is a list of 4, expected a list of 3");
  expect_difference({{"a", true}}, {{"a", 1}}, "/a", "is true, expected 1");
}

TEST(FirstDifference, AllowsFractionsTheirLastDigits) {
  for (const double value : {1e-3, 0.3, 1234.5}) {
    EXPECT_FALSE(first_difference(value * (1 + 0.9e-9), value));
    EXPECT_TRUE(first_difference(value * (1 + 1.1e-9), value));
    EXPECT_TRUE(first_difference(-value, value));
  }
  EXPECT_FALSE(first_difference(0.9e-14, 0.0));
  EXPECT_TRUE(first_difference(1.1e-14, 0.0));
}

TEST(FirstDifference, TakesAWholeNumberForAFractionButNotTheOtherWayRound) {
  EXPECT_FALSE(first_difference(20, 20.0));
  EXPECT_TRUE(first_difference(20.0, 20));
  EXPECT_TRUE(first_difference(1'000'000'001, 1'000'000'000));
}

}  // namespace
}  // namespace torquewright::gearbox
