// SPDX-License-Identifier: Apache-2.0
#include "gearbox/topologies/planetary.hpp"

#include <gtest/gtest.h>

#include "tests/gearbox/example_problem.hpp"

namespace torquewright::gearbox {
namespace {

Problem stage() {
  Problem problem = test::knee();
  problem.topology = "planetary";
  problem.constraints = ConstraintSet::kBuildable;
  problem.objective = Objective::kForwardEfficiency;
  problem.target_ratio = Rational(36, 5);
  problem.rotor_inner_diameter_mm = 100;
  problem.planet_count = {3};
  problem.min_teeth = {{"sun", 20}, {"planet", 20}};
  problem.min_carrier_clearance_rad = 0;
  return problem;
}

TEST(PlanetaryEvaluate, CompactsStage) {
  const DesignReport report = planetary::evaluate(stage(), {{25, 65}, 3, Rational(3, 5)});
  EXPECT_EQ(report.design.teeth, (std::vector<std::int64_t>{25, 65, 155}));
  EXPECT_EQ(report.ratio, Rational(36, 5));
  EXPECT_TRUE(report.feasible());
  EXPECT_EQ(report.constraints.size(), 14u);
  EXPECT_EQ(report.objective, report.forward_efficiency);
  EXPECT_NEAR(report.meshes[0].backlash_share, 0.5, 1e-15);
  EXPECT_FALSE(report.planet_tilting_force_N);
  EXPECT_NEAR(*report.input_torque_Nm, 320 / 7.2, 1e-12);
}

// Oracle: each planet carries the output torque to the carrier's arm, 2 F a n = T_C.
TEST(PlanetaryEvaluate, ToothForcesCarryTheOutputTorque) {
  const DesignReport report = planetary::evaluate(stage(), {{25, 65}, 3, Rational(3, 5)});
  const double centre_m = 0.0006 * (25 + 65) / 2;
  EXPECT_NEAR(2 * 3 * report.meshes[0].tangential_force_N * centre_m, 320, 1e-10);
}

TEST(PlanetaryEvaluate, AbsurdDesignsYieldNoNanAndNoInfinity) {
  for (const std::int64_t sun : {1, 2, 5, 40, 300}) {
    for (const std::int64_t planet : {1, 2, 5, 40, 300}) {
      for (const std::int64_t planets : {1, 2, 6, 100}) {
        EXPECT_TRUE(test::is_finite(
            planetary::evaluate(stage(), {{sun, planet}, planets, Rational(3, 5)})));
        for (const std::int64_t ring : {1, 5, 33, 34, 300}) {
          EXPECT_TRUE(test::is_finite(
              planetary::evaluate(stage(), {{sun, planet, ring}, planets, Rational(3, 5)})));
        }
      }
    }
  }
}

}  // namespace
}  // namespace torquewright::gearbox
