// SPDX-License-Identifier: Apache-2.0
#include "actuator/trajectory/slope_filter.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace torquewright::actuator {
namespace {

std::vector<Row> with_slopes(const std::vector<double>& times_s,
                             const std::function<double(double)>& value) {
  std::vector<Row> rows;
  SlopeFilter filter({{0, 1}}, [&](const Row& row) { rows.push_back(row); });
  for (const double time_s : times_s) filter.push({time_s, {value(time_s), -1.0}});
  filter.finish();
  return rows;
}

/// Steps between 0.3 and 1.7 times the mean.
std::vector<double> uneven_times_s(std::size_t intervals, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> step(0.3, 1.7);
  std::vector<double> times_s{0.0};
  for (std::size_t i = 0; i < intervals; ++i) {
    times_s.push_back(times_s.back() + step(random) / static_cast<double>(intervals));
  }
  return times_s;
}

// Oracle: closed form. The slope of a parabola is exact on any steps, at the ends as well; the
// tolerance is rounding over the smallest step (1e-16 / 3e-3 times some).
TEST(SlopeFilter, IsExactForParabolasOnUnevenSteps) {
  const auto times_s = uneven_times_s(100, 1);
  const auto rows = with_slopes(times_s, [](double t) { return 3.0 - 2.0 * t + 5.0 * t * t; });
  ASSERT_EQ(rows.size(), times_s.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    EXPECT_EQ(rows[i].time_s, times_s[i]);
    EXPECT_NEAR(rows[i].values[1], -2.0 + 10.0 * times_s[i], 1e-11);
  }
}

double worst_error(const std::vector<double>& times_s) {
  double worst = 0.0;
  for (const Row& row : with_slopes(times_s, [](double t) { return std::sin(7.0 * t); })) {
    worst = std::max(worst, std::abs(row.values[1] - 7.0 * std::cos(7.0 * row.time_s)));
  }
  return worst;
}

// Oracle: order of convergence against the closed form 7 cos(7 t). Every step is halved, so an
// error of second order falls to a quarter; a first-order method would halve it.
TEST(SlopeFilter, IsOfSecondOrderOnUnevenSteps) {
  std::vector<double> times_s = uneven_times_s(200, 2);
  double error = worst_error(times_s);
  for (int halvings = 0; halvings < 3; ++halvings) {
    std::vector<double> finer{times_s.front()};
    for (std::size_t i = 1; i < times_s.size(); ++i) {
      finer.push_back(0.5 * (times_s[i - 1] + times_s[i]));
      finer.push_back(times_s[i]);
    }
    const double finer_error = worst_error(finer);
    EXPECT_GT(error / finer_error, 3.5);
    EXPECT_LT(error / finer_error, 4.5);
    times_s = finer;
    error = finer_error;
  }
}

TEST(SlopeFilter, TakesTheQuotientOfTwoRowsAndNothingOfOne) {
  const auto two = with_slopes({1.0, 3.0}, [](double t) { return 4.0 * t; });
  EXPECT_EQ(two[0].values[1], 4.0);
  EXPECT_EQ(two[1].values[1], 4.0);
  EXPECT_EQ(with_slopes({1.0}, [](double) { return 9.0; }).at(0).values[1], 0.0);
  EXPECT_TRUE(with_slopes({}, [](double) { return 9.0; }).empty());
}

}  // namespace
}  // namespace torquewright::actuator
