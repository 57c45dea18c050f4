// SPDX-License-Identifier: Apache-2.0
// Oracle: the waves that a target was made of, which one by one sound in orders that are not there.
#include "identification/forward/wave_pursuit.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace torquewright::identification {
namespace {

constexpr std::size_t kOrders = 30;

/// A target over 0.7 of a turn, with orders 1 to 30 asked for and a constant beside them.
WavePursuit over_part_of_a_turn(double (*target)(double)) {
  WavePursuit pursuit(1, kOrders);
  Eigen::VectorXd row(2 + 2 * static_cast<Eigen::Index>(kOrders));
  constexpr int kRows = 3000;
  for (int i = 0; i < kRows; ++i) {
    const double angle = 0.7 * 2.0 * std::numbers::pi * i / kRows;
    row[0] = target(angle);
    row[1] = 1.0;
    for (std::size_t k = 0; k < kOrders; ++k) {
      const double phase = static_cast<double>(k + 1) * angle;
      const auto at = 2 + 2 * static_cast<Eigen::Index>(k);
      row[at] = std::sin(phase);
      row[at + 1] = std::cos(phase);
    }
    pursuit.add(row);
  }
  return pursuit;
}

TEST(WavePursuit, FindsTheWavesThatAreThereAndNoOthers) {
  const WavePursuit pursuit = over_part_of_a_turn([](double angle) {
    return 5.0 + std::sin(7.0 * angle + 0.3) + 0.3 * std::sin(14.0 * angle) +
           0.2 * std::cos(28.0 * angle + 1.0);
  });
  // Places count from order 1. Beside all of them nothing is left, so a share of a millionth
  // would be enough for another.
  EXPECT_EQ(pursuit.strongest(6, 1e-6), (std::vector<std::size_t>{6, 13, 27}));
}

TEST(WavePursuit, EndsAtTheMostAskedForAndAtTheLeastShare) {
  const WavePursuit pursuit = over_part_of_a_turn(
      [](double angle) { return std::sin(7.0 * angle) + 0.3 * std::sin(14.0 * angle); });
  EXPECT_EQ(pursuit.strongest(1, 1e-6), (std::vector<std::size_t>{6}));
  // The second holds about 0.09/1.09 of the power, a twelfth.
  EXPECT_EQ(pursuit.strongest(6, 0.15), (std::vector<std::size_t>{6}));
  EXPECT_EQ(pursuit.strongest(6, 0.04).size(), 2u);
}

// What the columns beside the waves hold is theirs: a target of them alone has no waves.
TEST(WavePursuit, IsSilentOnWhatTheColumnsHold) {
  const WavePursuit pursuit =
      over_part_of_a_turn([](double angle) { return 5.0 + 0.001 * std::sin(7.0 * angle); });
  EXPECT_EQ(pursuit.strongest(6, 1e-6), (std::vector<std::size_t>{6}));
}

}  // namespace
}  // namespace torquewright::identification
