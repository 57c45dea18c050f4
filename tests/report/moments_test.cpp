// SPDX-License-Identifier: Apache-2.0
// Oracle: the flights that are given.
#include "src/report/robot/moments.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace torquewright::report {
namespace {

/// Ten seconds at 100 Hz.
hopper::Motion motion() {
  hopper::Motion motion;
  for (int i = 0; i <= 1000; ++i) motion.times_s.push_back(0.01 * i);
  return motion;
}

hopper::Flight flight(double from_s, double until_s) {
  hopper::Flight flight;
  flight.from_s = from_s;
  flight.until_s = until_s;
  return flight;
}

int flown(const std::vector<Moment>& moments, double from_s, double until_s) {
  const hopper::Motion whole = motion();
  return static_cast<int>(std::count_if(moments.begin(), moments.end(), [&](const Moment& moment) {
    const double time_s = whole.time_s(moment.sample);
    return moment.is_in_flight && from_s < time_s && time_s < until_s;
  }));
}

TEST(Moments, HalfAreInFlightInProportionToEach) {
  const auto moments = moments_of(motion(), {flight(2.0, 2.3), flight(7.0, 7.6)}, 12);
  ASSERT_EQ(moments.size(), 12u);
  EXPECT_EQ(flown(moments, 2.0, 2.3), 2);
  EXPECT_EQ(flown(moments, 7.0, 7.6), 4);
  EXPECT_EQ(std::count_if(moments.begin(), moments.end(),
                          [](const Moment& moment) { return moment.is_in_flight; }),
            6);
  EXPECT_EQ(moments.front().sample, 0);
  EXPECT_EQ(moments.back().sample, 1000);
  EXPECT_TRUE(std::is_sorted(
      moments.begin(), moments.end(),
      [](const Moment& one, const Moment& other) { return one.sample < other.sample; }));
}

TEST(Moments, AreSpreadEvenlyWhereNothingFlies) {
  const auto moments = moments_of(motion(), {}, 11);
  for (std::size_t i = 0; i < moments.size(); ++i) {
    EXPECT_EQ(moments[i].sample, static_cast<Eigen::Index>(100 * i));
    EXPECT_FALSE(moments[i].is_in_flight);
  }
}

TEST(Moments, AreAllInFlightWhereNothingElseIs) {
  const auto moments = moments_of(motion(), {flight(0.0, 10.0)}, 12);
  EXPECT_EQ(moments.size(), 12u);
  EXPECT_TRUE(std::all_of(moments.begin(), moments.end(),
                          [](const Moment& moment) { return moment.is_in_flight; }));
}

}  // namespace
}  // namespace torquewright::report
