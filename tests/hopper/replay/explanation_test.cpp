// SPDX-License-Identifier: Apache-2.0
// Oracle: closed forms. A missing rotation that is a sum of independent parts has the sum of their
// variances; a uniform width of 2 a has the variance a^2/3.
#include "hopper/trials/explanation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "hopper/trials/causes.hpp"

namespace torquewright::hopper {
namespace {

constexpr double kRadians = M_PI / 180.0;

TrialOutcome landed_short(double short_rad, bool stands = true) {
  TrialOutcome outcome;
  outcome.verdict = stands ? ReplayVerdict::kStands : ReplayVerdict::kFell;
  outcome.rotation_short_rad = short_rad;
  return outcome;
}

/// A grid over two independent uniform parts of half width a and b; one of them alone where the
/// other's is 0.
TrialOutcomes grid(double a, double b) {
  constexpr int kSide = 400;
  TrialOutcomes outcomes;
  for (int i = 0; i < kSide; ++i) {
    for (int j = 0; j < (b > 0.0 ? kSide : 1); ++j) {
      const double x = a * (2.0 * (i + 0.5) / kSide - 1.0);
      const double y = b * (2.0 * (j + 0.5) / kSide - 1.0);
      outcomes.push_back(landed_short(x + y));
    }
  }
  return outcomes;
}

TEST(TrialExplanation, SharesOfVarianceAreThoseOfTheParts) {
  const TrialOutcomes all = grid(0.3, 0.1);
  const CauseEffect first = effect_of_cause("first", grid(0.3, 0.0), all);
  const CauseEffect second = effect_of_cause("second", grid(0.1, 0.0), all);
  ASSERT_TRUE(first.rotation && first.variance_share && second.variance_share);
  EXPECT_NEAR(first.rotation->deviation_rad, 0.3 / std::sqrt(3.0), 1e-3);
  EXPECT_NEAR(*first.variance_share, 0.9, 5e-3);
  EXPECT_NEAR(*second.variance_share, 0.1, 5e-3);
}

TEST(TrialExplanation, WithoutLandingsNothingIsSaidOfRotation) {
  const TrialOutcomes none(3);
  EXPECT_FALSE(rotation_spread(none));
  EXPECT_TRUE(rotation_bins(none).empty());
  const CauseEffect effect = effect_of_cause("cause", none, grid(0.3, 0.1));
  EXPECT_FALSE(effect.variance_share);
  EXPECT_EQ(effect.counts.unfinished, 3u);
}

TEST(TrialExplanation, BinsHoldEachTrialOnceAtItsPlace) {
  TrialOutcomes outcomes;
  for (const double degrees : {-6.5, -0.5, 0.5, 3.9, 7.9}) {
    outcomes.push_back(landed_short(degrees * kRadians, degrees < 4.0));
  }
  outcomes.emplace_back();  // never begun
  const std::vector<RotationBin> bins = rotation_bins(outcomes);
  // 14.4 degrees are covered by bins of 1 degree.
  ASSERT_EQ(bins.size(), 15u);
  EXPECT_DOUBLE_EQ(bins.front().from_deg, -7.0);
  EXPECT_DOUBLE_EQ(bins.back().until_deg, 8.0);
  std::size_t all = 0;
  for (const RotationBin& bin : bins) all += bin.succeeded + bin.failed;
  EXPECT_EQ(all, 5u);
  EXPECT_EQ(bins[10].succeeded, 1u);  // 3 to 4 degrees
  EXPECT_EQ(bins[14].failed, 1u);
  EXPECT_EQ(bins[6].succeeded, 1u);  // -1 to 0
}

TEST(TrialExplanation, EveryCauseStandsAlone) {
  Randomisation randomisation;
  randomisation.total_mass_factor = Range{0.9, 1.1};
  randomisation.restitution = Range{0.1, 0.1};  // no width
  randomisation.noise.base_rate_rad_s = 0.1;
  randomisation.noise.joint_position_rad = 0.05;
  const std::vector<Cause> causes = causes_of(randomisation);
  ASSERT_EQ(causes.size(), 3u);
  EXPECT_EQ(causes[0].name, "total_mass_factor");
  EXPECT_EQ(causes[1].name, "sensor_noise/base_rate_rad_s");
  EXPECT_EQ(causes[2].name, "sensor_noise/joint_position_rad");
  for (const Cause& cause : causes) {
    const std::vector<Cause> within = causes_of(cause.alone);
    ASSERT_EQ(within.size(), 1u) << cause.name;
    EXPECT_EQ(within[0].name, cause.name);
    EXPECT_FALSE(cause.alone.restitution);
  }
}

}  // namespace
}  // namespace torquewright::hopper
