// SPDX-License-Identifier: Apache-2.0
#include "gearbox/train/kinematics.hpp"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "tests/gearbox/linear_solve.hpp"

namespace torquewright::gearbox {
namespace {

// Oracle: published tables; half a unit of the last printed digit.
struct PublishedTrain {
  const char* source;
  ThreeKTeeth<double> teeth;
  double reduction;
  double half_digit;
};

TEST(ThreeKReduction, MeetsThePublishedRatios) {
  const std::vector<PublishedTrain> trains{
      {"seed 001", {44, 44, 32, 132, 120}, 20.0, 1e-12},
      {"Matsuki Table III", {12, 39, 32, 90, 81}, 96.24193548, 5e-9},
      {"PGS manual, appendix A", {12, 39, 20, 90, 54}, 58.5, 1e-12},
      {"SplitRingGears box 3", {8, 13, 11, 34, 29}, 659.75, 1e-10},
      {"reference, not buildable alike", {44, 42, 31, 128, 117}, 20.3058, 5e-5},
      {"COMPAct", {64, 48, 28, 160, 140}, 10.5, 1e-12},
      {"COMPAct", {72, 42, 30, 156, 144}, 14.0, 1e-12},
      {"COMPAct", {63, 35, 28, 133, 126}, 20.0, 1e-12},
      {"COMPAct", {54, 36, 30, 126, 120}, 26.667, 5e-4},
      {"COMPAct", {28, 40, 32, 108, 100}, 35.714, 5e-4},
      {"COMPAct", {36, 32, 28, 100, 96}, 42.667, 5e-4},
      {"COMPAct", {60, 48, 44, 156, 152}, 60.8, 1e-10}};
  for (const PublishedTrain& train : trains) {
    EXPECT_NEAR(three_k_reduction(train.teeth), train.reduction, train.half_digit) << train.source;
  }
}

TEST(ThreeKReduction, IsExactInFractions) {
  const mpq_class ratio = three_k_reduction<mpq_class>({12, 39, 20, 90, 54});
  EXPECT_EQ(ratio, mpq_class(117, 2));
}

TEST(ThreeKSpeeds, MeetThePgsManualAtAThousandTurns) {
  // PGS manual, appendix A: C +117.647, P -153.846, O +17.094, printed to three decimals.
  const ThreeKTeeth<double> teeth{12, 39, 20, 90, 54};
  EXPECT_NEAR(1000 * carrier_speed_per_sun(teeth.sun, teeth.fixed_ring), 117.647, 5e-4);
  EXPECT_NEAR(1000 * planet_speed_per_sun(teeth.sun, teeth.planet_1, teeth.fixed_ring), -153.846,
              5e-4);
  EXPECT_NEAR(1000 / three_k_reduction(teeth), 17.094, 5e-4);
}

TEST(ThreeKSpeeds, RelativeToTheCarrierAreThoseOfD151) {
  // Reference section 5, at 10 rad/s of the output: carrier 50, planet -150 and sun 150 to it.
  const ThreeKTeeth<double> teeth{44, 44, 32, 132, 120};
  const double sun_rad_s = 10.0 * three_k_reduction(teeth);
  const double carrier_rad_s = sun_rad_s * carrier_speed_per_sun(teeth.sun, teeth.fixed_ring);
  const double planet_rad_s =
      sun_rad_s * planet_speed_per_sun(teeth.sun, teeth.planet_1, teeth.fixed_ring);
  EXPECT_NEAR(sun_rad_s, 200.0, 1e-11);
  EXPECT_NEAR(carrier_rad_s, 50.0, 1e-11);
  EXPECT_NEAR(planet_rad_s - carrier_rad_s, -150.0, 1e-11);
}

TEST(PlanetaryReduction, MeetsThePublishedStages) {
  EXPECT_NEAR(planetary_reduction<double>({25, 65, 155}), 7.2, 1e-12);        // COMPAct
  EXPECT_NEAR(planetary_reduction<double>({23, 52, 127}), 6.5217, 5e-5);      // PGS
  EXPECT_NEAR(planetary_reduction<double>({12, 12, 36}), 4.0, 1e-12);         // PGS
  EXPECT_NEAR(1000 * carrier_speed_per_sun(12.0, 36.0), 250.0, 1e-10);        // PGS
  EXPECT_NEAR(1000 * planet_speed_per_sun(12.0, 12.0, 36.0), -500.0, 1e-10);  // PGS
}

// Oracle: equal pitch speeds at the three meshes as a linear system in carrier, planet and output.
TEST(ThreeKSpeeds, SolveTheMeshEquations) {
  std::mt19937 random(1);
  std::uniform_int_distribution<int> count(10, 150);
  for (int trial = 0; trial < 2000; ++trial) {
    const ThreeKTeeth<double> z{double(count(random)), double(count(random)), double(count(random)),
                                double(count(random)), double(count(random))};
    if (z.planet_1 * z.output_ring == z.fixed_ring * z.planet_2) continue;
    // z_S (1 - C) = -z1 (P - C);  z_F (0 - C) = z1 (P - C);  z_O (O - C) = z2 (P - C)
    const auto speeds =
        test::solve({test::Row{-z.sun - z.planet_1, z.planet_1, 0, -z.sun},
                     test::Row{z.planet_1 - z.fixed_ring, -z.planet_1, 0, 0},
                     test::Row{z.planet_2 - z.output_ring, -z.planet_2, z.output_ring, 0}});
    const double tolerance = 1e-11;  // 3x3 elimination, entries below 300
    EXPECT_NEAR(carrier_speed_per_sun(z.sun, z.fixed_ring), speeds[0], tolerance);
    EXPECT_NEAR(planet_speed_per_sun(z.sun, z.planet_1, z.fixed_ring), speeds[1],
                tolerance * (1 + std::abs(speeds[1])));
    EXPECT_NEAR(1.0 / three_k_reduction(z), speeds[2], tolerance * (1 + std::abs(speeds[2])));
  }
}

}  // namespace
}  // namespace torquewright::gearbox
