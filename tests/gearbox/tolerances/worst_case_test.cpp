// SPDX-License-Identifier: Apache-2.0
// The worst parts within their limits. Oracle: every corner of the limits, one by one; a scan of
// the centre distance; closed forms of the slopes.
#include "gearbox/tolerances/worst_case.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numeric>

#include "tests/gearbox/tolerances/tolerated_trains.hpp"

namespace torquewright::gearbox {
namespace {

using namespace test;

struct Range {
  double least = 1e300;
  double greatest = -1e300;

  void see(double value) {
    least = std::min(least, value);
    greatest = std::max(greatest, value);
  }
};

/// Over all corners, with the centre distance at so many places between its limits.
void visit_corners(const ToleratedTrain& train, int centre_places,
                   const std::function<void(Deviations)>& visit) {
  std::vector<std::size_t> others;
  std::size_t centre = 0;
  for (std::size_t i = 0; i < train.limits.size(); ++i) {
    const PartLimit& limit = train.limits[i];
    if (limit.dimension == Dimension::kCentreDistance) {
      centre = i;
    } else if (limit.width() > 0.0) {
      others.push_back(i);
    }
  }
  std::vector<double> deviations = nominal(train);
  for (std::size_t corner = 0; corner < std::size_t{1} << others.size(); ++corner) {
    for (std::size_t i = 0; i < others.size(); ++i) {
      const PartLimit& limit = train.limits[others[i]];
      deviations[others[i]] = (corner >> i & 1U) != 0 ? limit.greatest : limit.least;
    }
    for (int place = 0; place < centre_places; ++place) {
      const PartLimit& limit = train.limits[centre];
      deviations[centre] = limit.least + limit.width() * place / (centre_places - 1);
      visit(deviations);
    }
  }
}

TEST(WorstCase, OfAMeshIsTheWorstCorner) {
  for (const ToleratedTrain& train : {tolerated_drive(), tolerated_stage()}) {
    for (std::size_t mesh = 0; mesh < train.cut.meshes.size(); ++mesh) {
      Range backlash, contact, clearance;
      visit_corners(train, 3, [&](Deviations deviations) {
        const BuiltMesh built = built_mesh(train, mesh, deviations);
        backlash.see(built.backlash_mm);
        contact.see(built.contact_ratio);
        clearance.see(built.tip_clearance_mm());
      });
      const MeshWorstCase worst = worst_case_of_mesh(train, mesh);
      EXPECT_NEAR(worst.backlash_mm.least, backlash.least, 1e-12);
      EXPECT_NEAR(worst.backlash_mm.greatest, backlash.greatest, 1e-12);
      EXPECT_NEAR(worst.contact_ratio.least, contact.least, 1e-12);
      EXPECT_NEAR(worst.contact_ratio.greatest, contact.greatest, 1e-12);
      EXPECT_NEAR(worst.tip_clearance_mm.least, clearance.least, 1e-12);
      EXPECT_GE(worst.tip_clearance_mm.greatest, clearance.greatest - 1e-12);
      EXPECT_LT(backlash.least, backlash.greatest);
    }
  }
}

TEST(WorstCase, OfTheOutputIsTheWorstCornerWhereItsSlopeHasOneSign) {
  const ToleratedTrain train = tolerated_knee();
  Range output;
  visit_corners(train, 3,
                [&](Deviations deviations) { output.see(output_rad(train, deviations)); });
  const WorstCase worst = worst_case_of_output_rad(train);
  EXPECT_TRUE(worst.is_attained);
  EXPECT_NEAR(worst.least, output.least, 1e-14);
  EXPECT_NEAR(worst.greatest, output.greatest, 1e-14);
}

// Of a single stage without shift the centre distance opens one mesh as it closes the other: the
// slope is 0 everywhere, and the bound has to hold nevertheless.
TEST(WorstCase, OfTheOutputIsABoundWhereItsSlopeTurns) {
  const ToleratedTrain train = tolerated_stage();
  Range output;
  visit_corners(train, 21,
                [&](Deviations deviations) { output.see(output_rad(train, deviations)); });
  const WorstCase worst = worst_case_of_output_rad(train);
  EXPECT_FALSE(worst.is_attained);
  EXPECT_LE(worst.least, output.least);
  EXPECT_GE(worst.greatest, output.greatest);
  EXPECT_LT(worst.greatest - worst.least, 1.0001 * (output.greatest - output.least));
}

// Slopes by closed form: c_k cos(alpha) for a tooth's thickness, of planet 1 in two meshes, and the
// sum of +- 2 c_k sin(alpha) for the centre distance.
TEST(VarianceShares, AreThoseOfTheClosedForms) {
  const ToleratedTrain train = tolerated_knee();
  const std::vector<double>& c = train.output_rad_per_mm;
  const double cosine = std::cos(M_PI / 9.0), sine = std::sin(M_PI / 9.0);
  const std::map<std::string, double> slopes{{"centre_distance", 2.0 * sine * (c[0] - c[1] - c[2])},
                                             {"tooth_thickness.sun", -c[0] * cosine},
                                             {"tooth_thickness.planet_1", -(c[0] + c[1]) * cosine},
                                             {"tooth_thickness.planet_2", -c[2] * cosine},
                                             {"tooth_thickness.fixed_ring", -c[1] * cosine},
                                             {"tooth_thickness.output_ring", -c[2] * cosine}};
  double sum = 0.0;
  for (const PartLimit& limit : train.limits) {
    const auto slope = slopes.find(limit.name);
    if (slope != slopes.end()) sum += std::pow(slope->second * limit.width(), 2);
  }
  const std::vector<double> shares = variance_shares(train);
  for (std::size_t i = 0; i < shares.size(); ++i) {
    const auto slope = slopes.find(train.limits[i].name);
    const double expected =
        slope == slopes.end() ? 0.0 : std::pow(slope->second * train.limits[i].width(), 2) / sum;
    EXPECT_NEAR(shares[i], expected, 1e-9) << train.limits[i].name;
  }
  EXPECT_NEAR(std::accumulate(shares.begin(), shares.end(), 0.0), 1.0, 1e-12);
  EXPECT_NEAR(linear_deviation_rad(train, 1.0 / 12.0), std::sqrt(sum / 12.0), 1e-9);
}

TEST(VarianceShares, AreNothingWhereNothingVaries) {
  ToleratedTrain train = tolerated_knee();
  for (PartLimit& limit : train.limits) limit.least = limit.greatest = 0.0;
  for (const double share : variance_shares(train)) EXPECT_EQ(share, 0.0);
  const WorstCase worst = worst_case_of_output_rad(train);
  EXPECT_EQ(worst.least, worst.greatest);
}

}  // namespace
}  // namespace torquewright::gearbox
