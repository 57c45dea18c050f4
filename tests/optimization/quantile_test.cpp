// SPDX-License-Identifier: Apache-2.0
// Oracle: the places counted by hand. The shares are sums of powers of two, so that no rounding
// decides.
#include "optimization/fit/quantile.hpp"

#include <gtest/gtest.h>

namespace torquewright::optimization {
namespace {

TEST(Quantile, OfOneValueIsThatValue) {
  for (const double share : {0.0, 0.5, 1.0}) {
    EXPECT_EQ(nearest_quantile({7.0}, share), 7.0);
    EXPECT_EQ(lower_quantile({7.0}, share), 7.0);
  }
  EXPECT_EQ(median({7.0}), 7.0);
}

// Five values stand at the shares 0, 1/4, 1/2, 3/4 and 1.
TEST(Quantile, TakesTheNearestOrTheOneBefore) {
  const std::vector<double> values = {5.0, 1.0, 4.0, 2.0, 3.0};
  struct Case {
    double share, nearest, lower;
  };
  for (const Case& each : {Case{0.0, 1.0, 1.0}, Case{0.125, 2.0, 1.0}, Case{0.25, 2.0, 2.0},
                           Case{0.3125, 2.0, 2.0}, Case{0.4375, 3.0, 2.0}, Case{0.75, 4.0, 4.0},
                           Case{0.9375, 5.0, 4.0}, Case{1.0, 5.0, 5.0}}) {
    EXPECT_EQ(nearest_quantile(values, each.share), each.nearest) << each.share;
    EXPECT_EQ(lower_quantile(values, each.share), each.lower) << each.share;
  }
}

TEST(Median, IsTheMiddleOneOrTheGreaterOfTwo) {
  EXPECT_EQ(median({3.0, 1.0, 2.0}), 2.0);
  EXPECT_EQ(median({4.0, 3.0, 1.0, 2.0}), 3.0);
  EXPECT_EQ(nearest_quantile({4.0, 3.0, 1.0, 2.0}, 0.5), 3.0);
  EXPECT_EQ(lower_quantile({4.0, 3.0, 1.0, 2.0}, 0.5), 2.0);
}

}  // namespace
}  // namespace torquewright::optimization
