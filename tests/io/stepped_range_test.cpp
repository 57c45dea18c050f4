// SPDX-License-Identifier: Apache-2.0
// Ranges of an option. Oracle: decimal arithmetic by hand, which doubles miss: 0.1 + 0.1 + 0.1.
#include "io/text/stepped_range.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace torquewright::io {
namespace {

struct Refused : std::runtime_error {
  using std::runtime_error::runtime_error;
};

RangeRule rule() {
  return {.refuse = [](const std::string& why) { throw Refused(why); },
          .most = 100,
          .what = "ratios",
          .least = 0.01,
          .greatest = 1e4};
}

std::vector<double> values(const std::string& text) {
  std::vector<double> found;
  for (const Rational& value : values_of(read_stepped_range(text, rule()))) {
    found.push_back(nearest(value));
  }
  return found;
}

TEST(SteppedRange, CountsInDecimals) {
  EXPECT_EQ(values("0.1:0.5:0.1"), (std::vector<double>{0.1, 0.2, 0.3, 0.4, 0.5}));
  EXPECT_EQ(values("8:10"), (std::vector<double>{8, 9, 10}));
  EXPECT_EQ(values("8:10:1.5"), (std::vector<double>{8, 9.5}));
  EXPECT_EQ(values("8:8"), (std::vector<double>{8}));
  EXPECT_EQ(read_range_number("7.5", rule()), Rational(15, 2));
  EXPECT_TRUE(is_range("8:9"));
  EXPECT_FALSE(is_range("8"));
}

TEST(SteppedRange, SaysWhyATextIsNone) {
  const auto why = [](const std::string& text) -> std::string {
    try {
      values(text);
    } catch (const Refused& refused) {
      return refused.what();
    }
    return "taken";
  };
  EXPECT_EQ(why("8"), "it is no range");
  EXPECT_EQ(why("1:2:3:4"), "it is no range");
  EXPECT_EQ(why("8:x"), "\"x\" is not a number");
  EXPECT_EQ(why(":9"), "\"\" is not a number");
  EXPECT_EQ(why("8:9:0"), "the step 0 is not above 0");
  EXPECT_EQ(why("9:8"), "9 lies above 8");
  EXPECT_EQ(why("0.009:9"), "ratios are from 0.01 to 10000");
  EXPECT_EQ(why("5e-324:1e308"), "ratios are from 0.01 to 10000");
  EXPECT_EQ(why("1:100"), "taken");
  EXPECT_EQ(why("1:101"), "these are more than 100 ratios");
}

}  // namespace
}  // namespace torquewright::io
