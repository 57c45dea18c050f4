// SPDX-License-Identifier: Apache-2.0
#include "gearbox/train/assembly_phase.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>
#include <stdexcept>

namespace torquewright::gearbox {
namespace {

// Oracle: the table of published and brute-forced assembly results (identical planets or not).
TEST(AssemblyPhase, CountsThePlanetTypes) {
  EXPECT_EQ(assemble_3k({44, 44, 32, 132, 120}, 4).planet_types, 1);
  EXPECT_EQ(assemble_3k({12, 39, 32, 90, 81}, 3).planet_types, 1);
  EXPECT_EQ(assemble_3k({8, 13, 11, 34, 29}, 3).planet_types, 1);
  EXPECT_EQ(assemble_3k({44, 42, 31, 128, 117}, 4).planet_types, 2);
  EXPECT_EQ(assemble_3k({10, 23, 21, 56, 52}, 3).planet_types, 3);
}

// Oracle: for equal spacing the count is n / gcd(n, |Q|), over a sweep of coaxial sets.
TEST(AssemblyPhase, CountAgreesWithTheClosedForm) {
  for (std::int64_t s = 12; s < 40; ++s) {
    for (std::int64_t p1 = 15; p1 < 40; p1 += 3) {
      for (std::int64_t p2 = 14; p2 < 40; p2 += 5) {
        for (std::int64_t n = 2; n <= 6; ++n) {
          const CompoundTeeth teeth{s, p1, p2, s + 2 * p1, s + p1 + p2};
          const AssemblyPhase phase = assemble_3k(teeth, n);
          if (!phase.equally_spaced) continue;
          const std::int64_t q =
              (teeth.output_ring * p1 - teeth.fixed_ring * p2) / std::gcd(p1, p2);
          EXPECT_EQ(phase.planet_types, n / std::gcd(n, std::abs(q)));
        }
      }
    }
  }
}

TEST(AssemblyPhase, SpacesEquallyExactlyWhereItCan) {
  const AssemblyPhase equal = assemble_3k({44, 44, 32, 132, 120}, 4);
  EXPECT_TRUE(equal.equally_spaced);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_DOUBLE_EQ(equal.planets[i].position_rad,
                     0.5 * std::numbers::pi * static_cast<double>(i));
  }
  const AssemblyPhase unequal = assemble_planetary(43, 44, 131, 4);
  EXPECT_FALSE(unequal.equally_spaced);
  // 174 places, a quarter of them is 43.5: the second planet takes the 44th.
  EXPECT_DOUBLE_EQ(unequal.planets[1].position_rad, 2.0 * std::numbers::pi * 44.0 / 174.0);
}

TEST(AssemblyPhase, EqualPartNumbersMeanEqualClocking) {
  const AssemblyPhase phase = assemble_3k({44, 42, 31, 128, 117}, 4);
  EXPECT_EQ(phase.planets[0].part_number, 1);
  EXPECT_EQ(phase.planets[1].part_number, 2);
  EXPECT_EQ(phase.planets[2].part_number, 1);
  EXPECT_EQ(phase.planets[3].part_number, 2);
  EXPECT_EQ(phase.planets[0].clocking_rad, phase.planets[2].clocking_rad);
  EXPECT_NE(phase.planets[0].clocking_rad, phase.planets[1].clocking_rad);
}

TEST(AssemblyPhase, RefusesCountsThatAreNotPositive) {
  EXPECT_THROW((void)assemble_3k({0, 44, 32, 132, 120}, 4), std::invalid_argument);
  EXPECT_THROW((void)assemble_3k({44, 44, 32, 132, -1}, 4), std::invalid_argument);
  EXPECT_THROW((void)assemble_planetary(45, 30, 105, 0), std::invalid_argument);
}

}  // namespace
}  // namespace torquewright::gearbox
