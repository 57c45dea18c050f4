// SPDX-License-Identifier: Apache-2.0
// 3k_b and compound trains as they are evaluated. Oracles: counting by hand, the 3K train that is
// the same gears with the rings' parts exchanged, brute force over the turns of a planet.
#include "gearbox/topologies/stepped_train.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

#include "gearbox/strength/loaded_mesh.hpp"
#include "gearbox/topologies/topology.hpp"
#include "gearbox/train/assembly.hpp"
#include "gearbox/train/central_gears.hpp"
#include "tests/gearbox/example_problem.hpp"

namespace torquewright::gearbox {
namespace {

Problem problem_of(std::string topology) {
  Problem problem = test::knee();
  problem.topology = std::move(topology);
  problem.constraints = ConstraintSet::kBuildable;
  problem.objective = Objective::kHollowShaft;
  problem.min_teeth = {{"sun", 12}, {"planet_1", 12}, {"planet_2", 12}};
  problem.planet_count = {3, 4};
  problem.module_mm = {Rational(1, 2)};
  problem.target_ratio = 12;
  problem.ratio_tolerance = Rational(1, 2);
  problem.load_output_torque_Nm = Rational(100);
  problem.ring_outer_diameter_mm = std::nullopt;
  return problem;
}

const ConstraintReport& constraint_of(const DesignReport& report, std::string_view name) {
  const auto found = std::find_if(report.constraints.begin(), report.constraints.end(),
                                  [&](const ConstraintReport& each) { return each.name == name; });
  if (found == report.constraints.end()) throw std::invalid_argument(std::string(name));
  return *found;
}

// S 20, P1 40, P2 20, R 80: i = 1 + 40 80/(20 20) = 9; carrier at 1/9, planets at (1 - 80/20)/9.
TEST(Compound, IsCountedByHand) {
  const Problem problem = problem_of("compound");
  const Topology& topology = *find_topology("compound");
  EXPECT_EQ(topology.complete(std::vector<std::int64_t>{20, 40, 20}),
            (std::vector<std::int64_t>{20, 40, 20, 80}));
  const DesignReport report = topology.evaluate(problem, {{20, 40, 20, 80}, 3, Rational(1, 2)});
  EXPECT_EQ(report.ratio, 9);
  EXPECT_DOUBLE_EQ(report.carrier_speed_per_input, 1.0 / 9.0);
  EXPECT_DOUBLE_EQ(report.gears[1].speed_per_input, -3.0 / 9.0);
  EXPECT_DOUBLE_EQ(report.gears[2].speed_per_input, -3.0 / 9.0);
  EXPECT_NEAR(*report.fixed_ring_torque_Nm, 100.0 * 8.0 / 9.0, 1e-12);
  // Tips: a = 0.5 (20 + 40)/2 = 15 mm, planets of 0.5 42 = 21 mm across.
  EXPECT_NEAR(constraint_of(report, "planet_room.planet_1").value, 2.0 * 15.0 + 21.0, 1e-12);
  EXPECT_NEAR(constraint_of(report, "rotor_bore").value, 0.5 * (20.0 + 2.0 * 40.0), 1e-12);
  EXPECT_LT(report.forward_efficiency, 1.0);
  EXPECT_GT(report.backward_efficiency, 0.9);
}

// Planet 1 of a compound train meshes with the sun only, and that of a 3k_b train drives its ring
// by the flank that the sun pushes: neither bends both ways, as the one between sun and held ring.
TEST(SteppedTrains, BendBothWaysOnlyBetweenSunAndHeldRing) {
  const auto bends = [](const char* topology, std::vector<std::int64_t> teeth) {
    GearTrain train{topology, teeth, std::vector<double>(teeth.size()), 3, 0.5, {8.0, 8.0}};
    const LoadedTrain loaded = loaded_train(train);
    EXPECT_EQ(loaded.objections, std::vector<std::string>{}) << topology;
    return std::any_of(loaded.meshes.begin(), loaded.meshes.end(), [](const LoadedMesh& mesh) {
      return mesh.bends_both_ways[0] || mesh.bends_both_ways[1];
    });
  };
  EXPECT_TRUE(bends("3k", {44, 44, 32, 132, 120}));
  EXPECT_FALSE(bends("3k_b", {44, 44, 32, 132, 120}));
  EXPECT_FALSE(bends("compound", {24, 44, 22, 90}));
}

// Oracle: gears and meshes are those of a 3K train; only which ring is held differs.
TEST(ThreeKB, HasTheGearsOfA3kTrainWithItsRingsExchanged) {
  const Design design{{30, 30, 36, 90, 96}, 3, Rational(1, 2)};
  const DesignReport own = find_topology("3k_b")->evaluate(problem_of("3k_b"), design);
  const DesignReport other = find_topology("3k")->evaluate(problem_of("3k"), design);
  // I1 = F P1/(P2 S) = 96 30/(36 30) = 8/3, I2 = F P1/(P2 O) = 96 30/(36 90) = 8/9.
  EXPECT_EQ(own.ratio, Rational(33));
  EXPECT_EQ(own.planet_types, other.planet_types);
  ASSERT_EQ(own.meshes.size(), other.meshes.size());
  for (std::size_t i = 0; i < own.meshes.size(); ++i) {
    EXPECT_NEAR(own.meshes[i].efficiency, other.meshes[i].efficiency, 1e-12);
    EXPECT_NEAR(own.meshes[i].contact_ratio, other.meshes[i].contact_ratio, 1e-9);
  }
  EXPECT_EQ(own.gears[3].name, "output_ring");
  EXPECT_NEAR(own.gears[3].speed_per_input, 1.0 / 33.0, 1e-15);
  EXPECT_EQ(own.gears[4].speed_per_input, 0.0);
}

// Why no sun of such a train reaches under planet 2. Oracle: all small coaxial teeth.
TEST(ThreeKB, TurnsWithTheSunOnlyWithALargerPlanet2) {
  const Topology& topology = *find_topology("3k_b");
  EXPECT_FALSE(may_sun_pass(topology));
  EXPECT_TRUE(may_sun_pass(*find_topology("3k")));
  EXPECT_TRUE(may_sun_pass(*find_topology("compound")));
  EXPECT_FALSE(may_sun_pass(*find_topology("planetary")));
  for (std::int64_t s = 12; s <= 30; ++s) {
    for (std::int64_t p1 = 12; p1 <= 30; ++p1) {
      for (std::int64_t p2 = 12; p2 <= 30; ++p2) {
        if (p1 == p2) continue;
        const auto teeth = topology.complete(std::vector<std::int64_t>{s, p1, p2});
        const std::vector<double> real(teeth.begin(), teeth.end());
        EXPECT_EQ(topology.reduction(real) > 0.0, p2 > p1) << s << " " << p1 << " " << p2;
      }
    }
  }
}

TEST(ThreeKB, SaysWhereItsOutputStandsStill) {
  const Design design{{30, 30, 30, 90, 90}, 3, Rational(1, 2)};
  const DesignReport report = find_topology("3k_b")->evaluate(problem_of("3k_b"), design);
  EXPECT_EQ(report.ratio, 0);
  EXPECT_FALSE(constraint_of(report, "ratio").satisfied);
  EXPECT_TRUE(std::isfinite(report.output_backlash_rad_per_mm));
  EXPECT_TRUE(std::any_of(report.remarks.begin(), report.remarks.end(), [](const Remark& remark) {
    return remark.sentence == "efficiency: does not exist, the output stands still.";
  }));
}

/// Whether a planet that fits at the first place fits at the second of n, turned by a whole number
/// of parts of which all teeth are made: p1 x = s/n and p2 x = -r/n modulo whole turns.
bool fits_alike(std::int64_t n, std::int64_t s, std::int64_t p1, std::int64_t p2, std::int64_t r) {
  for (std::int64_t k = 0; k < p1; ++k) {
    // x = (k + s/n)/p1; p2 x + r/n = (p2 (k n + s) + r p1)/(n p1).
    if ((p2 * (k * n + s) + r * p1) % (n * p1) == 0) return true;
  }
  return false;
}

TEST(Compound, NeedsPlanetPartsAsBruteForceCounts) {
  std::mt19937 generator(8);
  const auto among = [&](int low, int high) {
    return low + static_cast<std::int64_t>(generator() % unsigned(high - low + 1));
  };
  const Problem problem = problem_of("compound");
  int alike = 0;
  for (int trial = 0; trial < 500; ++trial) {
    const std::int64_t s = among(12, 40), p1 = among(12, 40), p2 = among(12, 40);
    const std::int64_t r = s + p1 + p2 + among(-1, 1), n = among(3, 6);
    const bool fits = fits_alike(n, s, p1, p2, r);
    const AssemblyPhase phase =
        find_topology("compound")->assemble(std::vector<std::int64_t>{s, p1, p2, r}, n);
    EXPECT_EQ(phase.planet_types == 1, fits) << s << " " << p1 << " " << p2 << " " << r;
    const Design design{{s, p1, p2, r}, n, Rational(1, 2)};
    EXPECT_EQ(find_topology("compound")->evaluate(problem, design).planet_types,
              phase.planet_types);
    alike += fits ? 1 : 0;
  }
  EXPECT_GT(alike, 70);
}

}  // namespace
}  // namespace torquewright::gearbox
