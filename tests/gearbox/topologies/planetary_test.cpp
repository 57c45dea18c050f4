// SPDX-License-Identifier: Apache-2.0
#include "gearbox/topologies/planetary.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "gearbox/topologies/short_loss_form.hpp"
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

/// In the report's order.
std::vector<std::string> names_of(const std::vector<ConstraintReport>& constraints) {
  std::vector<std::string> names;
  for (const ConstraintReport& constraint : constraints) names.push_back(constraint.name);
  return names;
}

// Oracle: reference section 12, COMPAct's stage at mu = 0.3 by the short form.
TEST(ShortLossForm, IsThatOfAPublishedStage) {
  Problem problem = stage();
  problem.friction_coefficient = Rational(3, 10);
  const DesignReport report = planetary::evaluate(problem, {{25, 65}, 3, Rational(3, 5)});
  EXPECT_NEAR(short_form_efficiency("planetary", report).forward, .9595, 5e-5);
}

// Oracle: the list of docs/gearbox_constraints.md; no ring's wall, since no outer diameter is
// asked for.
TEST(PlanetaryEvaluate, ReportsEveryDocumentedConstraint) {
  const DesignReport report = planetary::evaluate(stage(), {{25, 65}, 3, Rational(3, 5)});
  EXPECT_EQ(names_of(report.constraints),
            (std::vector<std::string>{
                "ratio", "min_teeth.sun", "min_teeth.planet", "carrier_clearance", "rotor_bore",
                "equal_spacing", "neighbour_clearance.layer_1", "undercut.sun", "undercut.planet",
                "ring_wall.ring", "ring_tip.ring", "interference.involute.planet_ring",
                "interference.trochoid.planet_ring", "contact_ratio.sun_planet",
                "contact_ratio.planet_ring"}));
}

// Oracle: the documented conditions by hand, for 25/65/155 with three planets of module 0.6.
TEST(PlanetaryEvaluate, JudgesByTheDocumentedConditions) {
  const DesignReport report = planetary::evaluate(stage(), {{25, 65}, 3, Rational(3, 5)});
  const auto value = [&](const char* name) { return test::find(report, name)->value; };
  const double half_arc_rad = std::numbers::pi / 3.0;
  EXPECT_NEAR(value("ratio"), 1.0 + 155.0 / 25.0, 1e-14);
  EXPECT_NEAR(value("carrier_clearance"), half_arc_rad - std::asin(65.0 / 90.0), 1e-14);
  EXPECT_NEAR(value("rotor_bore"), 0.6 * 155.0, 1e-12);
  EXPECT_EQ(value("equal_spacing"), 0.0);  // 3 divides 25 + 155
  EXPECT_NEAR(value("neighbour_clearance.layer_1"),
              0.6 * (25.0 + 65.0) * std::sin(half_arc_rad) - 0.6 * 67.0, 1e-12);
  EXPECT_NEAR(value("ring_tip.ring"),
              0.6 * (153.0 - 155.0 * std::cos(std::numbers::pi / 9.0)) / 2.0, 1e-12);
}

TEST(PlanetaryEvaluate, CompactsStage) {
  const DesignReport report = planetary::evaluate(stage(), {{25, 65}, 3, Rational(3, 5)});
  EXPECT_EQ(report.design.teeth, (std::vector<std::int64_t>{25, 65, 155}));
  EXPECT_EQ(report.ratio, Rational(36, 5));
  EXPECT_TRUE(report.feasible());
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
