// SPDX-License-Identifier: Apache-2.0
// Oracle: the curve itself. Whatever is left out, its extremes and the gaps in it stay.
#include "src/report/parts/kept_samples.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace torquewright::report {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr Index kLong = 100000;

/// A slow wave with two spikes of one sample each.
VectorXd spiky() {
  VectorXd values(kLong);
  for (Index i = 0; i < kLong; ++i) values[i] = std::sin(1e-4 * static_cast<double>(i));
  values[31417] = 50.0;
  values[77777] = -40.0;
  return values;
}

bool holds(const std::vector<Index>& samples, Index wanted) {
  return std::binary_search(samples.begin(), samples.end(), wanted);
}

TEST(CurveSamples, KeepEverySpikeAndTheEnds) {
  const std::vector<Index> kept = curve_samples(spiky(), 400);
  EXPECT_LE(kept.size(), 2 * 400 + 2u);
  EXPECT_TRUE(std::is_sorted(kept.begin(), kept.end()));
  for (const Index wanted : {Index{0}, Index{31417}, Index{77777}, kLong - 1}) {
    EXPECT_TRUE(holds(kept, wanted)) << wanted;
  }
}

TEST(CurveSamples, KeepAGap) {
  VectorXd values = spiky();
  values.segment(50000, 20).setConstant(std::nan(""));
  EXPECT_TRUE(holds(curve_samples(values, 400), 50000));
}

TEST(CurveSamples, KeepAllOfAShortCurve) {
  EXPECT_EQ(curve_samples(VectorXd::Ones(800), 400).size(), 800u);
}

TEST(CursorSamples, AreSpreadOverTheTimeWithExtremesAndWhatIsWanted) {
  std::vector<double> times_s;
  for (Index i = 0; i < kLong; ++i) times_s.push_back(1e-3 * static_cast<double>(i));
  const VectorXd values = spiky();
  const std::vector<Index> kept = cursor_samples(times_s, {&values}, {12345}, 1500);
  EXPECT_LE(kept.size(), 1500 + 3u);
  for (const Index wanted : {Index{0}, Index{12345}, Index{31417}, Index{77777}, kLong - 1}) {
    EXPECT_TRUE(holds(kept, wanted)) << wanted;
  }
  for (std::size_t i = 1; i < kept.size(); ++i) EXPECT_LE(kept[i] - kept[i - 1], kLong / 1500 + 2);
  times_s.resize(1500);
  EXPECT_EQ(cursor_samples(times_s, {}, {}, 1500).size(), 1500u);
}

}  // namespace
}  // namespace torquewright::report
