// SPDX-License-Identifier: Apache-2.0
#include "gearbox/teeth/profile_shift.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "gearbox/teeth/shifted_mesh.hpp"

namespace torquewright::gearbox {
namespace {

double degrees(double angle_rad) { return angle_rad * 180.0 / std::numbers::pi; }

TEST(InverseInvolute, UndoesTheInvolute) {
  for (double angle_rad = 1e-3; angle_rad < 1.55; angle_rad += 1e-3) {
    const double value = std::tan(angle_rad) - angle_rad;
    // d(angle) = d(value)/tan^2(angle); near zero tan(x) - x has lost all but its absolute accuracy
    const double tolerance = 1e-15 + 4e-16 * std::tan(angle_rad) / std::pow(std::tan(angle_rad), 2);
    EXPECT_NEAR(*inverse_involute_rad(value), angle_rad, 4 * tolerance) << angle_rad;
  }
  EXPECT_EQ(*inverse_involute_rad(0.0), 0.0);
  EXPECT_FALSE(inverse_involute_rad(-1e-9));
  EXPECT_FALSE(inverse_involute_rad(std::nan("")));
}

TEST(ExternalShift, MeetsSdpSiTable) {
  // SDP/SI D785 table 4-3: m 3, 12/24, x .6/.36; the table rounds its shifts, which the reference
  // gives to two digits: centre distance 56.4999.
  const ShiftedPair pair{MeshKind::kExternal, 12, 24, .6, .36};
  const double angle = *working_angle_rad(pair);
  const double centre = centre_distance(pair, angle);
  const double increment = centre_increment(pair, centre);
  EXPECT_NEAR(degrees(angle), 26.0886, 5e-5);
  EXPECT_NEAR(increment, .83333, 5e-5);
  EXPECT_NEAR(3 * centre, 56.5, 5e-4);
  const double tip_1 = tip_diameter_keeping_clearance(12, .36, increment);
  const double tip_2 = tip_diameter_keeping_clearance(24, .6, increment);
  EXPECT_NEAR(3 * tip_1, 44.840, 5e-4);
  EXPECT_NEAR(3 * tip_2, 79.400, 5e-4);
  EXPECT_NEAR(3 * 2 * centre * 12 / 36, 37.667, 5e-4);
  EXPECT_NEAR(3 * 2 * centre * 24 / 36, 75.333, 5e-4);
  const auto path = contact_path({pair, angle, tip_1, tip_2});
  EXPECT_NEAR(contact_ratio(*path), 1.202, 5e-4);
}

TEST(InternalShift, MeetsSdpSiTable) {
  // SDP/SI D785 table 5-4: ring 50, x1 = 0, m = 1.
  struct Row {
    double planet, ring_shift, angle_deg, centre, ratio;
  };
  for (const Row& row :
       {Row{49, 1.00, 61.0605, .971, 1.105}, Row{47, .40, 37.4155, 1.775, 1.726},
        Row{45, .20, 28.2019, 2.666, 1.933}, Row{43, .06, 22.3755, 3.557, 2.053}}) {
    const ShiftedPair pair{MeshKind::kInternal, row.planet, 50, 0.0, row.ring_shift};
    const double angle = *working_angle_rad(pair);
    const CutPair cut{pair, angle, tip_diameter_external(row.planet, 0.0),
                      tip_diameter_ring(50, row.ring_shift)};
    EXPECT_NEAR(degrees(angle), row.angle_deg, 5.001e-5);
    EXPECT_NEAR(centre_distance(pair, angle), row.centre, 5.001e-4);
    EXPECT_NEAR(contact_ratio(*contact_path(cut)), row.ratio, 5e-4);
    EXPECT_GE(*involute_interference_margin(cut), 0.0);
    EXPECT_GE(*trochoid_interference_margin(cut), 0.0);
    if (row.planet <= 46) {
      EXPECT_LT(*trimming_margin(cut), 0.0);
    }
  }
}

TEST(ShiftedTrain, MeetsMatsukisGeometry) {
  // Matsuki: m1 .8, m2 .8467, x S .476, P1 .762, F 2.000, P2 .536, O 1.210.
  const ShiftedPair sun{MeshKind::kExternal, 12, 39, .476, .762};
  const ShiftedPair fixed{MeshKind::kInternal, 39, 90, .762, 2.000};
  const ShiftedPair output{MeshKind::kInternal, 32, 81, .536, 1.210};
  const double angle_a = *working_angle_rad(sun);
  const double angle_b = *working_angle_rad(fixed);
  const double angle_c = *working_angle_rad(output);
  // x are printed to three digits: 1e-3 of shift moves the angle by 2 tan(20) 1e-3/(51 tan^2) rad,
  // 0.0036 degrees, and a by 0.0005 mm; the sums of these x happen to agree with the print
  EXPECT_NEAR(degrees(angle_a), 25.6645, 5e-5);
  EXPECT_NEAR(degrees(angle_b), 25.6645, 5e-5);
  EXPECT_NEAR(degrees(angle_c), 23.5777, 5e-5);
  EXPECT_NEAR(.8 * centre_distance(sun, angle_a), 21.26791, 5e-6);
  EXPECT_NEAR(.8 * centre_distance(fixed, angle_b), 21.26791, 5e-6);
  // the reference takes this one from the angle rounded to 5e-5 degrees: a tan(alpha_w) times that
  // is 8.1e-6 mm, and half a digit
  EXPECT_NEAR(.8467 * centre_distance(output, angle_c), 21.26867, 1.4e-5);

  const double increment = centre_increment(sun, centre_distance(sun, angle_a));
  const double tip_1 = tip_diameter_planet_1(39, .762, .476, increment);
  const double tip_sun = tip_diameter_keeping_clearance(12, .762, increment);
  const double tip_fixed = tip_diameter_ring(90, 2.0);
  EXPECT_NEAR(contact_ratio(*contact_path({sun, angle_a, tip_sun, tip_1})), 1.232, 5e-4);
  EXPECT_NEAR(contact_ratio(*contact_path({fixed, angle_b, tip_1, tip_fixed})), 1.3163, 5e-5);
  // the published 1.420 takes planet 1's tip without the reduction of the min() rule
  const double full_tip = tip_diameter_external(39, .762);
  EXPECT_NEAR(contact_ratio(*contact_path({fixed, angle_b, full_tip, tip_fixed})), 1.420, 5e-4);
  const CutPair cut{output, angle_c, tip_diameter_external(32, .536), tip_diameter_ring(81, 1.21)};
  EXPECT_NEAR(contact_ratio(*contact_path(cut)), 1.565, 5.001e-4);
}

}  // namespace
}  // namespace torquewright::gearbox
