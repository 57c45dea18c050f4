// SPDX-License-Identifier: Apache-2.0
#include "gearbox/train/assembly.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <set>

namespace torquewright::gearbox {
namespace {

using Teeth = ThreeKTeeth<std::int64_t>;

TEST(Assembly, PublishedTrainsHaveIdenticalPlanets) {
  EXPECT_TRUE(has_identical_planets({44, 44, 32, 132, 120}, 4));  // seed 001
  EXPECT_TRUE(has_identical_planets({12, 39, 32, 90, 81}, 3));    // Matsuki Table III
  EXPECT_TRUE(has_identical_planets({12, 39, 20, 90, 54}, 3));    // PGS manual, appendix A
  EXPECT_TRUE(has_identical_planets({8, 13, 11, 34, 29}, 3));     // SplitRingGears box 3
}

TEST(Assembly, CounterexampleMeetsEquationFourAndNeedsTwoPlanets) {
  EXPECT_EQ(spacing_remainder(44, 128, 4), 0);
  EXPECT_FALSE(has_identical_planets({44, 42, 31, 128, 117}, 4));
  EXPECT_EQ(planet_type_count({44, 42, 31, 128, 117}, 4), 2);
  EXPECT_EQ(planet_type_count({10, 23, 21, 56, 52}, 3), 3);  // reference section 3
}

/// Oracle: with planet 1 engaged in the fixed ring in each of its z1 ways, the phases that planet 2
/// then has against the output ring, in units of 1/(n z1) of a tooth.
std::set<std::int64_t> phases_at(const Teeth& z, std::int64_t planet_count, std::int64_t position) {
  std::set<std::int64_t> phases;
  const std::int64_t whole = planet_count * z.planet_1;
  for (std::int64_t way = 0; way < z.planet_1; ++way) {
    const std::int64_t phase = z.planet_2 * (way * planet_count - z.fixed_ring * position) +
                               z.output_ring * position * z.planet_1;
    phases.insert((phase % whole + whole) % whole);
  }
  return phases;
}

Teeth random_teeth(std::mt19937& random) {
  std::uniform_int_distribution<std::int64_t> count(5, 60);
  return {count(random), count(random), count(random), 40 + count(random), 40 + count(random)};
}

TEST(Assembly, StarConditionAgreesWithTheSearchOverToothPhases) {
  std::mt19937 random(2);
  std::uniform_int_distribution<std::int64_t> planets(2, 7);
  int feasible = 0;
  for (int trial = 0; trial < 4000; ++trial) {
    const Teeth teeth = random_teeth(random);
    const std::int64_t count = planets(random);
    bool alike = true;
    std::set<std::set<std::int64_t>> types;
    for (std::int64_t position = 0; position < count; ++position) {
      const auto phases = phases_at(teeth, count, position);
      alike = alike && phases.contains(0);
      types.insert(phases);
    }
    feasible += alike ? 1 : 0;
    EXPECT_EQ(has_identical_planets(teeth, count), alike);
    EXPECT_EQ(planet_type_count(teeth, count), static_cast<std::int64_t>(types.size()));
  }
  EXPECT_GT(feasible, 100);  // both answers occur
  EXPECT_LT(feasible, 3900);
}

TEST(Assembly, ClockingBringsEveryPlanetIntoTheOutputRing) {
  std::mt19937 random(3);
  for (int trial = 0; trial < 300; ++trial) {
    const Teeth z = random_teeth(random);
    for (std::int64_t position = 0; position < 5; ++position) {
      const double clocking_rad = planet_clocking_rad(z, 5, position);
      const double turn = 2.0 * std::numbers::pi;
      double best = 1.0;
      for (std::int64_t way = 0; way < z.planet_1; ++way) {
        const double planet_turns =
            (static_cast<double>(way) - static_cast<double>(z.fixed_ring * position) / 5.0) /
            static_cast<double>(z.planet_1);
        const double phase =
            static_cast<double>(z.planet_2) * (planet_turns + clocking_rad / turn) +
            static_cast<double>(z.output_ring * position) / 5.0;
        best = std::min(best, std::abs(phase - std::round(phase)));
      }
      EXPECT_LT(best, 1e-10);  // phases up to 500 teeth, rounding 1e-13
      EXPECT_GE(clocking_rad, 0.0);
    }
  }
}

TEST(Assembly, SpacingUnitHoldsForTheSunMesh) {
  // A planet at k units needs (S + F) k/(S + F) whole teeth: an identity; the number is the test.
  EXPECT_DOUBLE_EQ(spacing_unit_rad(44, 132), 2.0 * std::numbers::pi / 176.0);
  EXPECT_EQ(spacing_remainder(44, 132, 3), 2);
}

TEST(Assembly, SurvivesProductsBeyondSixtyFourBits) {
  const std::int64_t huge = 4'000'000'000;
  EXPECT_EQ(planet_type_count({huge, huge, huge - 1, 3 * huge, 3 * huge - 1}, 7), 7);
  // O P1 - F P2 = (3h - 1) h - 3h (h - 1) = 2 h, g = 1; 2 h mod 7 = 8e9 mod 7 = 5, so 7 types.
}

TEST(Assembly, PhasingAndHuntingByDefinition) {
  EXPECT_EQ(phasing(132, 4), Phasing::kInPhase);
  EXPECT_EQ(phasing(133, 4), Phasing::kSequential);
  EXPECT_EQ(phasing(131, 4), Phasing::kSequential);
  EXPECT_EQ(phasing(134, 4), Phasing::kCounter);
  EXPECT_TRUE(is_hunting(23, 52));
  EXPECT_FALSE(is_hunting(44, 32));
}

}  // namespace
}  // namespace torquewright::gearbox
