// SPDX-License-Identifier: Apache-2.0
#include "gearbox/train/loads.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "gearbox/teeth/tooth_geometry.hpp"
#include "gearbox/train/backlash.hpp"
#include "gearbox/train/inertia.hpp"
#include "tests/gearbox/linear_solve.hpp"

namespace torquewright::gearbox {
namespace {

ThreeKTeeth<double> random_coaxial(std::mt19937& random) {
  std::uniform_int_distribution<int> count(12, 60);
  ThreeKTeeth<double> z = coaxial_three_k<double>(count(random), count(random), count(random));
  while (z.planet_1 == z.planet_2)
    z = coaxial_three_k<double>(count(random), count(random), count(random));
  return z;
}

TEST(Loads, OfD151) {
  // Reference section 7: 320 Nm, n 4, m .6: T_S 16, T_F 304; F_S 303, F_F 1919, F_O 2222 N.
  const ThreeKTeeth<double> teeth{44, 44, 32, 132, 120};
  const ThreeKLoads loads = three_k_loads(320, 20, 4, working_radii(teeth, 0.0264));
  EXPECT_NEAR(loads.sun_torque_Nm, 16, 1e-12);
  EXPECT_NEAR(loads.fixed_ring_torque_Nm, 304, 1e-12);
  EXPECT_NEAR(loads.sun_force_N, 303, .5);
  EXPECT_NEAR(loads.fixed_ring_force_N, 1919, .5);
  EXPECT_NEAR(loads.output_ring_force_N, 2222, .5);
}

// Oracles: a free carrier (forces on a planet cancel), a planet that spins freely, conserved power.
TEST(Loads, BalanceForcesMomentsAndPower) {
  std::mt19937 random(6);
  for (int trial = 0; trial < 500; ++trial) {
    const ThreeKTeeth<double> z = random_coaxial(random);
    const double centre_m = 0.0005 * (z.sun + z.planet_1) * 1.01;  // with shift: not the reference
    const double reduction = three_k_reduction(z);
    const ThreeKLoads loads = three_k_loads(100, reduction, 3, working_radii(z, centre_m));
    const double scale = std::abs(loads.output_ring_force_N) + std::abs(loads.fixed_ring_force_N);
    EXPECT_NEAR(loads.sun_force_N + loads.fixed_ring_force_N, loads.output_ring_force_N,
                1e-12 * scale);
    // lever arms are the planets' own working radii: of planet 1 in both of its meshes the sums
    const double at_sun_m = centre_m * z.planet_1 / (z.sun + z.planet_1);
    const double at_fixed_m = centre_m * z.planet_1 / (z.fixed_ring - z.planet_1);
    const double at_output_m = centre_m * z.planet_2 / (z.output_ring - z.planet_2);
    EXPECT_NEAR(loads.fixed_ring_force_N * at_fixed_m - loads.sun_force_N * at_sun_m,
                loads.output_ring_force_N * at_output_m, 1e-12 * scale * centre_m * 10);
    EXPECT_NEAR(loads.sun_torque_Nm * reduction, 100, 1e-10);
    EXPECT_EQ(loads.tilting_force_N(), loads.output_ring_force_N);
  }
}

// Oracle: gaps in the mesh equations, sun and fixed ring held:
//   -r_S C + r_1 (P - C) = j_a,  -r_F C - r_1 (P - C) = j_b,  r_O (O - C) - r_2 (P - C) = j_c
TEST(Backlash, SolvesTheGapEquations) {
  std::mt19937 random(7);
  for (int trial = 0; trial < 500; ++trial) {
    const ThreeKTeeth<double> z = random_coaxial(random);
    const ThreeKBacklash closed =
        three_k_backlash(basic_ratio_1(z), basic_ratio_2(z), {z.sun, z.fixed_ring, z.output_ring});
    const auto output = [&](double a, double b, double c) {
      return std::abs(
          test::solve({test::Row{-z.sun - z.planet_1, z.planet_1, 0, a},
                       test::Row{-z.fixed_ring + z.planet_1, -z.planet_1, 0, b},
                       test::Row{z.planet_2 - z.output_ring, -z.planet_2, z.output_ring, c}})[2]);
    };
    EXPECT_NEAR(closed.sun_planet_1, output(1, 0, 0), 1e-13);
    EXPECT_NEAR(closed.planet_1_fixed_ring, output(0, 1, 0), 1e-13);
    EXPECT_NEAR(closed.planet_2_output_ring, output(0, 0, 1), 1e-13);
  }
}

TEST(Backlash, OfD151) {
  // Reference section 10: shares 7/43/50 %, 30 um each at the pitch circles: 0.095 degrees.
  const ThreeKRadii pitch_m{.0132, .0396, .036};
  const ThreeKBacklash shares = three_k_backlash(3.0, 0.8, pitch_m);
  EXPECT_NEAR(shares.sun_planet_1 / shares.total(), .07, 5e-3);
  EXPECT_NEAR(shares.planet_1_fixed_ring / shares.total(), .43, 5e-3);
  EXPECT_NEAR(shares.planet_2_output_ring / shares.total(), .50, 5e-3);
  EXPECT_NEAR(shares.total() * 30e-6 * 180 / std::numbers::pi, .095, 6e-4);
}

TEST(Backlash, OfTheSingleStageSolvesItsGapEquations) {
  // Same elimination without the output ring: C = (j_a + j_b)/(r_S + r_R).
  const auto held = test::solve({test::Row{-25. - 65., 65., 0, 1},
                                 test::Row{-155. + 65., -65., 0, 0}, test::Row{0, 0, 1, 0}});
  EXPECT_NEAR(planetary_backlash(25, 155), std::abs(held[0]), 1e-15);
}

/// Oracle: the kinetic energy of every body at its own speed, from the mesh equations.
double energy_at_sun_speed_1(const Blank& blank, double rotor, double planets,
                             const ThreeKTeeth<double>& z) {
  const auto speed =
      test::solve({test::Row{-z.sun - z.planet_1, z.planet_1, 0, -z.sun},
                   test::Row{z.planet_1 - z.fixed_ring, -z.planet_1, 0, 0},
                   test::Row{z.planet_2 - z.output_ring, -z.planet_2, z.output_ring, 0}});
  const auto solid = [&](double width, double outer, double inner) {  // {mass, inertia}
    const double mass =
        blank.density_kg_m3 * width * std::numbers::pi / 4 * (outer * outer - inner * inner);
    return std::pair{mass, mass * (outer * outer + inner * inner) / 8};
  };
  const double m = blank.module_m;
  const double rim = 2.5 * m + 2 * blank.wall_m;
  const auto sun = solid(blank.face_width_1_m, m * z.sun, std::max(0.0, m * z.sun - rim));
  const auto first = solid(blank.face_width_1_m, m * z.planet_1, 0);
  const auto second = solid(blank.face_width_2_m, m * z.planet_2, 0);
  const auto ring = solid(blank.face_width_2_m, m * z.output_ring + rim, m * z.output_ring);
  const double centre = m * (z.sun + z.planet_1) / 2;
  const double planet = (first.first + second.first) * std::pow(centre * speed[0], 2) +
                        (first.second + second.second) * std::pow(speed[1], 2);
  return (rotor + sun.second + planets * planet + ring.second * speed[2] * speed[2]) / 2;
}

TEST(ReflectedInertia, HoldsTheKineticEnergy) {
  std::mt19937 random(8);
  for (int trial = 0; trial < 300; ++trial) {
    const ThreeKTeeth<double> z = random_coaxial(random);
    const Blank blank{0.0006, 7850, 0.008, 0.011, 0.00135};
    const double at_sun = three_k_inertia_at_sun_kg_m2(blank, 1e-5, 4, z);
    const double energy = energy_at_sun_speed_1(blank, 1e-5, 4, z);
    EXPECT_NEAR(at_sun / 2, energy, 1e-11 * energy);
    const double reduction = three_k_reduction(z);
    const double at_output = reflected_inertia_kg_m2(reduction, at_sun);
    EXPECT_NEAR(at_output / (reduction * reduction) / 2, energy, 1e-11 * energy);
  }
}

TEST(ReflectedInertia, OfD151RotorAlone) {
  // Reference section 9: rotor .000922 at 20:1 gives .369 kg m^2; bodies without density weigh
  // nothing.
  const Blank weightless{0.0006, 0.0, 0.008, 0.008, 0.00135};
  const double at_sun =
      three_k_inertia_at_sun_kg_m2<double>(weightless, .000922, 4, {44, 44, 32, 132, 120});
  EXPECT_NEAR(reflected_inertia_kg_m2(20.0, at_sun), .369, 5e-4);
}

TEST(Mass, IsVolumeTimesDensity) {
  // Oracle: pi/4 (d_out^2 - d_in^2) b rho of every body by hand, in whole millimetres: m = 1,
  // wall 2.25, so a rim of 7 mm; S 20, P1 30, P2 20, F 80, O 70; b 10 and 5; n 3.
  const Blank blank{1e-3, 1000.0, 10e-3, 5e-3, 2.25e-3};
  const double square_mm2 = 3 * (30 * 30 * 10 + 20 * 20 * 5) + (87 * 87 - 80 * 80) * 10 +
                            (77 * 77 - 70 * 70) * 5 + (20 * 20 - 13 * 13) * 10;
  EXPECT_NEAR(three_k_mass_kg(blank, 3, coaxial_three_k<double>(20, 30, 20)),
              square_mm2 * 1e-9 * 1000.0 * std::numbers::pi / 4, 1e-14);
  const double stage_mm2 = 3 * 30 * 30 * 10 + (87 * 87 - 80 * 80) * 10 + (20 * 20 - 13 * 13) * 10;
  EXPECT_NEAR(planetary_mass_kg(blank, 3, coaxial_planetary<double>(20, 30)),
              stage_mm2 * 1e-9 * 1000.0 * std::numbers::pi / 4, 1e-14);
  // a sun too small for its rim is a full disc
  EXPECT_NEAR(sun_mass_kg(blank, 6.0), 36 * 10 * 1e-9 * 1000.0 * std::numbers::pi / 4, 1e-17);
}

}  // namespace
}  // namespace torquewright::gearbox
