// SPDX-License-Identifier: Apache-2.0
// Gearboxes drawn by chance. Oracles: the propagation of variances, the worst case, the order of
// minima, the closed form of a yield.
#include "gearbox/tolerances/drawn_builds.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "gearbox/tolerances/worst_case.hpp"
#include "tests/gearbox/tolerances/tolerated_trains.hpp"

namespace torquewright::gearbox {
namespace {

using namespace test;

constexpr double kSigmas = 4.0;

ToleratedTrain with_planets(ToleratedTrain train, std::int64_t count) {
  train.cut.train.planet_count = count;
  return train;
}

// Of one planet the output's backlash is a sum of independent terms, straight but for the centre
// distance's curvature, which is 1e-4 of the whole. A sample's standard deviation is within
// sigma/sqrt(2 n) of it where the tails are no heavier than a normal number's.
TEST(DrawnBuilds, SpreadAsTheVariancesAddUp) {
  const ToleratedTrain train = with_planets(tolerated_knee(), 1);
  std::vector<double> middle;
  for (const PartLimit& limit : train.limits) middle.push_back(limit.middle());
  for (const Distribution distribution : {Distribution::kEven, Distribution::kNormal}) {
    const DrawnBuilds drawn = drawn_builds(train, {20'000, 7, distribution}, {});
    const double n = static_cast<double>(drawn.builds);
    const double sigma_rad = linear_deviation_rad(train, variance_per_width_squared(distribution));
    EXPECT_NEAR(drawn.output_rad.standard_deviation, sigma_rad,
                kSigmas * sigma_rad / std::sqrt(2.0 * n));
    EXPECT_NEAR(drawn.output_rad.mean, output_rad(train, middle),
                kSigmas * sigma_rad / std::sqrt(n) + 1e-4 * sigma_rad);
  }
}

// Oracle: the integral of x^2 over the normal density, between -3 and 3, by Simpson's rule.
TEST(DrawnBuilds, KnowTheVarianceOfACutNormalNumber) {
  constexpr int kSteps = 6000;
  double squares = 0.0, whole = 0.0;
  for (int i = 0; i <= kSteps; ++i) {
    const double x = -3.0 + 6.0 * i / kSteps;
    const double weight = (i == 0 || i == kSteps ? 1.0 : i % 2 == 1 ? 4.0 : 2.0);
    squares += weight * x * x * std::exp(-0.5 * x * x);
    whole += weight * std::exp(-0.5 * x * x);
  }
  EXPECT_NEAR(variance_per_width_squared(Distribution::kNormal), squares / whole / 36.0, 1e-12);
}

TEST(DrawnBuilds, LieWithinTheWorstCase) {
  for (const ToleratedTrain& train : {tolerated_knee(), tolerated_drive(), tolerated_stage()}) {
    const DrawnBuilds drawn = drawn_builds(train, {5'000, 3, Distribution::kEven}, {});
    for (std::size_t mesh = 0; mesh < drawn.meshes.size(); ++mesh) {
      const MeshWorstCase worst = worst_case_of_mesh(train, mesh);
      EXPECT_GE(drawn.meshes[mesh].backlash_mm.least, worst.backlash_mm.least);
      EXPECT_LE(drawn.meshes[mesh].backlash_mm.greatest, worst.backlash_mm.greatest);
      EXPECT_GE(drawn.meshes[mesh].contact_ratio.least, worst.contact_ratio.least);
      EXPECT_LE(drawn.meshes[mesh].contact_ratio.greatest, worst.contact_ratio.greatest);
      EXPECT_GE(drawn.meshes[mesh].tip_clearance_mm.least, worst.tip_clearance_mm.least);
      EXPECT_LE(drawn.meshes[mesh].tip_clearance_mm.greatest, worst.tip_clearance_mm.greatest);
    }
    const WorstCase worst = worst_case_of_output_rad(train);
    EXPECT_GE(drawn.output_rad.least, worst.least);
    EXPECT_LE(drawn.output_rad.greatest, worst.greatest);
  }
}

TEST(DrawnBuilds, AreTheSameForTheSameSeed) {
  const ToleratedTrain train = tolerated_knee();
  const auto median = [&](std::uint64_t seed) {
    return drawn_builds(train, {500, seed, Distribution::kEven}, {}).output_rad.median;
  };
  EXPECT_EQ(median(5), median(5));
  EXPECT_NE(median(5), median(6));
}

// The least of four is less than one; a standard deviation of what planets have of their own lies
// between.
TEST(DrawnBuilds, AreHeldByTheTightestPlanet) {
  const auto mean_rad = [](std::int64_t planets) {
    return drawn_builds(with_planets(tolerated_knee(), planets), {5'000, 1, Distribution::kEven},
                        {})
        .output_rad.mean;
  };
  EXPECT_LT(mean_rad(4), mean_rad(2));
  EXPECT_LT(mean_rad(2), mean_rad(1));
}

// One thickness alone varies, evenly, and the limit cuts off a quarter of it: Binomial's deviation.
TEST(DrawnBuilds, CountTheGoodOnes) {
  ToleratedTrain train = tolerated_knee();
  for (PartLimit& limit : train.limits) {
    limit.least = limit.greatest = 0.0;
    if (limit.name == "tooth_thickness.output_ring") limit.least = -0.04;
    if (limit.name == "tooth_thickness.planet_1") limit.least = limit.greatest = -0.02;
  }
  std::vector<double> three_quarters = but(train, "tooth_thickness.output_ring", -0.03);
  for (std::size_t i = 0; i < three_quarters.size(); ++i) {
    if (train.limits[i].name == "tooth_thickness.planet_1") three_quarters[i] = -0.02;
  }
  BuildDemands demands;
  demands.max_backlash_rad = output_rad(train, three_quarters);
  const DrawnBuilds drawn = drawn_builds(train, {10'000, 2, Distribution::kEven}, demands);
  EXPECT_NEAR(static_cast<double>(drawn.good), 7500.0, kSigmas * std::sqrt(10'000 * 0.25 * 0.75));
  EXPECT_EQ(drawn.missed.output_backlash, drawn.builds - drawn.good);
  EXPECT_EQ(drawn.missed.backlash, 0U);
  demands = {2.5, std::nullopt};
  EXPECT_EQ(drawn_builds(train, {10, 2, Distribution::kEven}, demands).missed.contact_ratio, 10U);
}

// Thicker teeth than nominal bind; longer tips reach the root beyond 0.25 modules.
TEST(DrawnBuilds, SayWhyTheyAreNotGood) {
  ToleratedTrain train = tolerated_knee();
  for (PartLimit& limit : train.limits) {
    limit.least = limit.greatest = 0.0;
    if (limit.name == "tooth_thickness.sun") limit.least = limit.greatest = 0.01;
    if (limit.name == "tip_diameter.planet_2") limit.least = limit.greatest = 0.31;
  }
  const DrawnBuilds drawn = drawn_builds(train, {10, 2, Distribution::kEven}, {});
  EXPECT_EQ(drawn.good, 0U);
  EXPECT_EQ(drawn.missed.backlash, 10U);
  EXPECT_EQ(drawn.missed.tip_clearance, 10U);
  EXPECT_EQ(drawn.missed.output_backlash, 0U);
}

}  // namespace
}  // namespace torquewright::gearbox
