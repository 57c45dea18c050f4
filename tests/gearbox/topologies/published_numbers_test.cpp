// SPDX-License-Identifier: Apache-2.0
// Published numbers that no other test here holds; docs/published_numbers.md lists where each is.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>

#include "gearbox/teeth/shifted_mesh.hpp"
#include "gearbox/topologies/three_k.hpp"
#include "gearbox/train/assembly.hpp"
#include "gearbox/train/power_flow.hpp"
#include "tests/gearbox/example_problem.hpp"

namespace torquewright::gearbox {
namespace {

// Reference section 3: sun 12-99, planet 1 below 80, ring at most 180; planet 2 from 12.
TEST(PublishedAssembly, HowManySetsNeedDifferentPlanets) {
  struct Row {
    std::int64_t planets, sets, different;
  };
  for (const Row& row : {Row{4, 58764, 20094}, Row{6, 39183, 13291}, Row{3, 0, 0}, Row{5, 0, 0}}) {
    std::int64_t sets = 0;
    std::int64_t different = 0;
    for (std::int64_t sun = 12; sun < 100; ++sun) {
      for (std::int64_t first = 13; first < 80 && sun + 2 * first <= 180; ++first) {
        if (spacing_remainder(sun, sun + 2 * first, row.planets) != 0) continue;
        for (std::int64_t second = 12; second < first; ++second) {
          const ThreeKTeeth<std::int64_t> teeth{sun, first, second, sun + 2 * first,
                                                sun + first + second};
          const bool alike = has_identical_planets(teeth, row.planets);
          ++sets;
          different += alike ? 0 : 1;
          // the same section: n | ((P1 - P2)/g)(S + P1)
          const std::int64_t product = (first - second) / std::gcd(first, second) * (sun + first);
          ASSERT_EQ(alike, product % row.planets == 0);
        }
      }
    }
    EXPECT_EQ(different, row.different) << row.planets;  // none for odd n
    if (row.sets > 0) {
      EXPECT_EQ(sets, row.sets);
    }
  }
}

TEST(PublishedAssembly, EquationFourIsNotForUnequalModules) {
  // Reference section 3: Matsuki's planets are alike, 279/(3 * 1) = 93, although 2 (O - P2)/n is
  // 98/3.
  EXPECT_EQ((81 * 39 - 90 * 32) / std::gcd(39, 32), 279);
  EXPECT_TRUE(has_identical_planets({12, 39, 32, 90, 81}, 3));
  EXPECT_NE(2 * (81 - 32) % 3, 0);
}

// Reference section 6: at i = 20, D = 79.4, m = .6, mu = .08 a bigger sun costs efficiency.
TEST(PublishedEfficiency, FallsWithTheSun) {
  struct Row {
    std::vector<std::int64_t> teeth;
    double ratio, efficiency;
  };
  for (const Row& row : {Row{{24, 48, 28}, 20, .968}, Row{{44, 44, 32}, 20, .957},
                         Row{{66, 24, 20}, 20, .894}, Row{{77, 25, 21}, 19.97, .895}}) {
    const DesignReport report = three_k::evaluate(test::knee(), {row.teeth, 4, Rational(3, 5)});
    EXPECT_NEAR(io::nearest(report.ratio), row.ratio, 5e-3);
    EXPECT_NEAR(report.forward_efficiency, row.efficiency, 5.001e-4);
  }
}

double loss_per_friction(const CutPair& cut, double curvature) {
  return std::numbers::pi * curvature * sliding_loss_factor(*contact_path(cut));
}

CutPair matsuki_cut(MeshKind kind, double z1, double z2, double x1, double x2, double tip_1,
                    double tip_2) {
  const ShiftedPair pair{kind, z1, z2, x1, x2};
  return {pair, *working_angle_rad(pair), tip_1, tip_2};
}

// Reference sections 6 and 12: mesh efficiencies from Matsuki's geometry; with mu = .10 the train
// gives .91975/.91511, with mu = .14 89.05/88.17 %.
TEST(PublishedEfficiency, OfMatsukiFromItsGeometry) {
  const ShiftedPair sun_pair{MeshKind::kExternal, 12, 39, .476, .762};
  const double increment =
      centre_increment(sun_pair, centre_distance(sun_pair, *working_angle_rad(sun_pair)));
  const double tip_1 = tip_diameter_planet_1(39, .762, .476, increment);
  const double tip_sun = tip_diameter_keeping_clearance(12, .762, increment);
  const CutPair a = matsuki_cut(MeshKind::kExternal, 12, 39, .476, .762, tip_sun, tip_1);
  const CutPair b =
      matsuki_cut(MeshKind::kInternal, 39, 90, .762, 2.0, tip_1, tip_diameter_ring(90, 2.0));
  const CutPair c = matsuki_cut(MeshKind::kInternal, 32, 81, .536, 1.21,
                                tip_diameter_external(32, .536), tip_diameter_ring(81, 1.21));
  const auto train = [&](double friction) {
    const ThreeKMeshEfficiencies<double> mesh{
        1 - friction * loss_per_friction(a, 1. / 12 + 1. / 39),
        1 - friction * loss_per_friction(b, 1. / 39 - 1. / 90),
        1 - friction * loss_per_friction(c, 1. / 32 - 1. / 81)};
    const ThreeKTeeth<double> teeth{12, 39, 32, 90, 81};
    return std::pair{mesh, three_k_efficiency(basic_ratio_1(teeth), basic_ratio_2(teeth), mesh)};
  };
  const auto [mesh, tenth] = train(.10);
  EXPECT_NEAR(mesh.sun_planet_1, .98179, 5.001e-6);
  EXPECT_NEAR(mesh.planet_1_fixed_ring, .99741, 5.001e-6);
  EXPECT_NEAR(mesh.planet_2_output_ring, .99605, 5.001e-6);
  EXPECT_NEAR(tenth.forward, .91975, 5.001e-6);
  EXPECT_NEAR(tenth.backward, .91511, 5.001e-6);
  const TrainEfficiency measured_like = train(.14).second;
  EXPECT_NEAR(measured_like.forward, .8905, 5.001e-5);
  EXPECT_NEAR(measured_like.backward, .8817, 5.001e-5);
}

// Reference section 6: the uniform average over the path gives .239 for C14 instead of .199, with
// tips that are not shortened.
TEST(PublishedEfficiency, UniformAverageOfC14) {
  const ShiftedPair pair{MeshKind::kExternal, 16, 24, .1817, .1715};
  const CutPair cut{pair, *working_angle_rad(pair), tip_diameter_external(16, .1817),
                    tip_diameter_external(24, .1715)};
  const ContactPath<double> path = *contact_path(cut);
  const double uniform =
      (path.approach * path.approach + path.recess * path.recess) / contact_ratio(path);
  const double scale = std::numbers::pi * (1. / 16 + 1. / 24);
  EXPECT_NEAR(scale * uniform, .239, 5e-4);
  EXPECT_NEAR(scale * sliding_loss_factor(path), .199, 5e-4);
}

// Reference section 11, seed 001 table II: peak torques are lossless; 306 Nm are left of 320.
TEST(PublishedTorques, AreLossless) {
  const DesignReport report = three_k::evaluate(test::knee(), {{44, 44, 32}, 4, Rational(3, 5)});
  EXPECT_NEAR(.32 * 50 * io::nearest(report.ratio), 320, 1e-12);
  EXPECT_NEAR(.44 * 50 * 8, 176, 1e-12);
  EXPECT_NEAR(.32 * 50 * io::nearest(report.ratio) * report.forward_efficiency, 306, .5);
}

// Reference section 10: root circle 24.9 mm, published hollow shaft 12 mm: 6.45 mm a side.
TEST(PublishedHollowShaft, LeavesTheWall) {
  Problem problem = test::knee();
  problem.hollow_shaft_wall_mm = Rational(645, 100);
  const DesignReport report = three_k::evaluate(problem, {{44, 44, 32}, 4, Rational(3, 5)});
  EXPECT_NEAR(report.hollow_shaft_diameter_mm, 12, 1e-12);
}

TEST(PublishedTilting, TwoKilonewtonsAtTenMillimetres) {
  // Reference section 7: about 20 Nm per planet at 10 mm; the force there is F_O (2222 N), which
  // makes it 22 Nm: docs/derivations/kinematics.md eq. (15).
  const DesignReport report = three_k::evaluate(test::knee(), {{44, 44, 32}, 4, Rational(3, 5)});
  EXPECT_NEAR(*report.planet_tilting_force_N * 10e-3, 22.2, .05);
}

}  // namespace
}  // namespace torquewright::gearbox
