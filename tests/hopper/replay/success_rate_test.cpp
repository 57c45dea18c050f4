// SPDX-License-Identifier: Apache-2.0
#include "hopper/trials/success_rate.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace torquewright::hopper {
namespace {

/// Of a function that is negative at one end and positive at the other.
double root_of(const std::function<double(double)>& function, double negative, double positive) {
  for (int i = 0; i < 200; ++i) {
    const double middle = 0.5 * (negative + positive);
    (function(middle) < 0.0 ? negative : positive) = middle;
  }
  return 0.5 * (negative + positive);
}

constexpr double kPrinted = 5.001e-5;  // half a unit of the fourth decimal

// Oracle: the score method without correction in the table of R. G. Newcombe, Two-sided confidence
// intervals for the single proportion, Statistics in Medicine 17 (1998), and the values for ten
// trials that every table of the method has.
TEST(WilsonInterval, IsAsPublished) {
  struct Row {
    std::size_t succeeded, tried;
    double least, greatest;
  };
  for (const Row& row :
       {Row{81, 263, 0.2553, 0.3662}, Row{15, 148, 0.0624, 0.1605}, Row{0, 20, 0.0, 0.1611},
        Row{1, 29, 0.0061, 0.1718}, Row{0, 10, 0.0, 0.2775}, Row{5, 10, 0.2366, 0.7634},
        Row{10, 10, 0.7225, 1.0}}) {
    const ShareInterval interval = wilson_interval(row.succeeded, row.tried);
    EXPECT_NEAR(interval.least, row.least, kPrinted) << row.succeeded << " of " << row.tried;
    EXPECT_NEAR(interval.greatest, row.greatest, kPrinted) << row.succeeded << " of " << row.tried;
  }
}

// Oracle: the ends are where the score test just does not reject, found by halving; its quantile
// from the library's error function.
TEST(WilsonInterval, EndsWhereTheScoreTestDoes) {
  const double quantile =
      root_of([](double z) { return 0.5 * std::erfc(-z / std::sqrt(2.0)) - 0.975; }, 0.0, 5.0);
  // The test's own root is a square root's: halving finds it to about the root of rounding.
  constexpr double kTolerance = 1e-9;
  for (const std::size_t tried : {1u, 2u, 7u, 200u, 100000u}) {
    for (const std::size_t succeeded : {std::size_t{0}, tried / 3, tried / 2, tried}) {
      const auto n = static_cast<double>(tried);
      const double share = static_cast<double>(succeeded) / n;
      const auto excess = [&](double p) {
        return std::abs(share - p) - quantile * std::sqrt(p * (1.0 - p) / n);
      };
      const ShareInterval interval = wilson_interval(succeeded, tried);
      const double least = succeeded == 0 ? 0.0 : root_of(excess, share, 0.0);
      const double greatest = succeeded == tried ? 1.0 : root_of(excess, share, 1.0);
      EXPECT_NEAR(interval.least, least, kTolerance) << succeeded << " of " << tried;
      EXPECT_NEAR(interval.greatest, greatest, kTolerance) << succeeded << " of " << tried;
    }
  }
}

TEST(WilsonInterval, OfNothingIsEverything) {
  EXPECT_EQ(wilson_interval(0, 0).least, 0.0);
  EXPECT_EQ(wilson_interval(0, 0).greatest, 1.0);
  EXPECT_THROW((void)wilson_interval(3, 2), std::invalid_argument);
}

TEST(SuccessInterval, LeavesOutWhatIsUnfinished) {
  const ShareInterval with = success_interval({5, 5, 90});
  const ShareInterval without = wilson_interval(5, 10);
  EXPECT_EQ(with.least, without.least);
  EXPECT_EQ(with.greatest, without.greatest);
}

// Oracle: the definition, whatever the unfinished ones would do.
TEST(JudgedRate, AsksAllTrials) {
  EXPECT_EQ(judged_rate({200, 0, 0}, 1.0), RateVerdict::kReached);
  EXPECT_EQ(judged_rate({199, 1, 0}, 1.0), RateVerdict::kMissed);
  EXPECT_EQ(judged_rate({199, 0, 1}, 1.0), RateVerdict::kOpen);
  EXPECT_EQ(judged_rate({190, 5, 5}, 0.95), RateVerdict::kReached);
  EXPECT_EQ(judged_rate({189, 5, 6}, 0.95), RateVerdict::kOpen);
  EXPECT_EQ(judged_rate({189, 11, 0}, 0.95), RateVerdict::kMissed);
  EXPECT_EQ(judged_rate({0, 0, 0}, 0.0), RateVerdict::kOpen);
  EXPECT_EQ(judged_rate({0, 10, 0}, 0.0), RateVerdict::kReached);
  EXPECT_THROW((void)judged_rate({1, 0, 0}, 1.1), std::invalid_argument);
  EXPECT_THROW((void)judged_rate({1, 0, 0}, std::nan("")), std::invalid_argument);
}

// Oracle: whole percents of a hundred trials; 0.29 times 100 is 28.999999999999996.
TEST(JudgedRate, TakesDecimalsAsTheyAreWritten) {
  for (std::size_t percent = 1; percent <= 100; ++percent) {
    const double required = static_cast<double>(percent) / 100.0;
    EXPECT_EQ(judged_rate({percent, 100 - percent, 0}, required), RateVerdict::kReached) << percent;
    EXPECT_EQ(judged_rate({percent - 1, 101 - percent, 0}, required), RateVerdict::kMissed)
        << percent;
  }
}

}  // namespace
}  // namespace torquewright::hopper
