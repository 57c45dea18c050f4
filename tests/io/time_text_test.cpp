// SPDX-License-Identifier: Apache-2.0
// Oracle: decimals written out by hand.
#include "io/text/time_text.hpp"

#include <gtest/gtest.h>

namespace torquewright::io {
namespace {

TEST(TimeText, HasSixDigitsEarlyInAMotion) {
  EXPECT_EQ(time_text(0.0), "0");
  EXPECT_EQ(time_text(0.61234567), "0.612346");
  EXPECT_EQ(time_text(1.5), "1.5");
  EXPECT_EQ(time_text(-12.34567), "-12.3457");
  EXPECT_EQ(time_text(0.61234567, 4), "0.6123");
}

// A tenth of a millisecond is told apart however long a clock has run.
TEST(TimeText, KeepsTenthsOfAMillisecondLater) {
  EXPECT_EQ(time_text(123.45678), "123.4568");
  EXPECT_EQ(time_text(12345.6139), "12345.6139");
  EXPECT_EQ(time_text(-86399.99994), "-86399.9999");
  EXPECT_EQ(time_text(12345.6139, 4), "12345.61");
  EXPECT_EQ(time_text(1e300), "1.0000000000000001e+300");
}

}  // namespace
}  // namespace torquewright::io
