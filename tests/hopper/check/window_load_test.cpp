// SPDX-License-Identifier: Apache-2.0
// Oracles: triangles by hand, and trying windows on a fine grid.
#include "hopper/check/window_load.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace torquewright::hopper {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

struct Signal {
  std::vector<double> times_s;
  VectorXd values, impulses, doubts, bends;

  explicit Signal(std::vector<double> times)
      : times_s(std::move(times)),
        values(VectorXd::Zero(static_cast<Index>(times_s.size()))),
        impulses(values),
        doubts(values),
        bends(values) {}

  WindowLoad over(double window_s) const {
    return greatest_window({times_s, values, impulses, doubts, bends}, window_s);
  }
};

// A triangle of height 6 from 1 to 5 with its top at 2. The best window of 2 cuts it at one height
// h at both ends: 4 (1 - h/6) = 2, h = 3, from 1.5 to 3.5; its mean is (3 + 6)/2 = 4.5.
TEST(WindowLoad, BeginsBetweenSamplesWhereThatIsWorst) {
  for (const double sign : {1.0, -1.0}) {
    Signal signal({0, 1, 2, 5, 6});
    signal.values << 0, 0, sign * 6, 0, 0;
    const WindowLoad load = signal.over(2.0);
    EXPECT_NEAR(load.mean, 4.5, 1e-14);
    EXPECT_NEAR(load.time_s, 1.5, 1e-14);
    EXPECT_NEAR(load.without_impulses, 4.5, 1e-14);
  }
}

// What pushes and pulls in one window cancels: the teeth pass the integral.
TEST(WindowLoad, IsTheIntegralsSizeNotThatOfTheSignal) {
  Signal signal({0, 1, 1, 2});
  signal.values << 4, 4, -4, -4;
  EXPECT_NEAR(signal.over(2.0).mean, 0.0, 1e-14);
  EXPECT_NEAR(signal.over(1.0).mean, 4.0, 1e-14);
}

TEST(WindowLoad, AddsTheImpulsesOfBothItsEnds) {
  Signal signal({0, 1, 2, 3, 4});
  signal.values.setConstant(-2.0);
  signal.impulses << 0, 3, 0, 4, 0;
  EXPECT_NEAR(signal.over(2.0).mean, 2.0 + 7.0 / 2.0, 1e-14);
  EXPECT_NEAR(signal.over(2.0).time_s, 1.0, 1e-14);
  EXPECT_NEAR(signal.over(2.0).without_impulses, 2.0, 1e-14);
  EXPECT_NEAR(signal.over(1.5).mean, 2.0 + 4.0 / 1.5, 1e-14);
}

TEST(WindowLoad, OfAShortSignalIsThatOfItsLength) {
  Signal signal({0, 1});
  signal.values << 2, 4;
  EXPECT_NEAR(signal.over(10.0).mean, 3.0, 1e-14);
  Signal instant({5});
  instant.values << -7;
  EXPECT_EQ(instant.over(10.0).mean, 7.0);
  EXPECT_EQ(instant.over(10.0).most, 7.0);
}

// Doubts of one sign add up and cancel others, bends only add up; what the window cuts counts
// whole.
TEST(WindowLoad, IsAsDoubtfulAsItsIntervals) {
  Signal signal({0, 1, 2, 3, 4, 5});
  signal.values << 0, 1, 1, 1, 1, 0;
  signal.doubts << 0, 0, 0.25, -0.5, 0.125, 0;
  const WindowLoad load = signal.over(3.0);  // from 1 to 4
  EXPECT_NEAR(load.mean, 1.0, 1e-14);
  EXPECT_NEAR(load.doubt, 0.125 / 3.0, 1e-14);
  EXPECT_NEAR(load.least, 1.0 - 0.125 / 3.0, 1e-14);
  signal.bends << 0, 0, 0.1, 0.1, 0.1, 0;
  EXPECT_NEAR(signal.over(3.0).doubt, (0.125 + 0.3) / 3.0, 1e-14);
  signal.bends.setZero();
  signal.values << 0, 1, 1, 1, 1, 1;
  const WindowLoad inside = signal.over(0.5);  // the first that is full begins at 1
  EXPECT_NEAR(inside.doubt, 0.25 / 0.5, 1e-14);
  EXPECT_NEAR(inside.most, 1.0 + 0.5 / 0.5, 1e-14);  // of the window between 2 and 3
}

// Oracle: windows that begin on a grid 2000 times finer than the samples. The mean of one changes
// by no more than (range of the values) times step over length from one to the next.
TEST(WindowLoad, IsTheGreatestOfAllThatAFineGridFinds) {
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> step(0.05, 1.0);
  for (int trial = 0; trial < 30; ++trial) {
    std::vector<double> times_s{0.0};
    while (times_s.size() < 12) times_s.push_back(times_s.back() + step(random));
    Signal signal(times_s);
    for (double& value : signal.values) value = normal(random);
    const double window_s = 0.3 + step(random);
    constexpr int kSteps = 20000;
    const double last_s = times_s.back() - window_s;
    const auto value_at = [&](double t) {
      std::size_t k = 1;
      while (k + 1 < times_s.size() && times_s[k] < t) ++k;
      const double share = (t - times_s[k - 1]) / (times_s[k] - times_s[k - 1]);
      const auto i = static_cast<Index>(k);
      return signal.values[i - 1] + share * (signal.values[i] - signal.values[i - 1]);
    };
    const double h = times_s.back() / kSteps;
    std::vector<double> integral{0.0};
    for (int i = 1; i <= kSteps; ++i) {
      integral.push_back(integral.back() + 0.5 * h * (value_at((i - 1) * h) + value_at(i * h)));
    }
    const auto until = [&](double t) {
      const int i = std::min(static_cast<int>(t / h), kSteps - 1);
      return integral[static_cast<std::size_t>(i)] + (t - i * h) * value_at(i * h);
    };
    double best = 0.0;
    for (int i = 0; i * h <= last_s; ++i) {
      best = std::max(best, std::abs(until(i * h + window_s) - until(i * h)) / window_s);
    }
    const double range = signal.values.maxCoeff() - signal.values.minCoeff();
    const double most_between = 2.0 * range * h / window_s;
    EXPECT_NEAR(signal.over(window_s).mean, best, most_between) << trial;
  }
}

}  // namespace
}  // namespace torquewright::hopper
