// SPDX-License-Identifier: Apache-2.0
#include "gearbox/topologies/planetary.hpp"

#include <gtest/gtest.h>

#include <algorithm>
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
                "contact_ratio.planet_ring", "root_form.hob.sun_planet",
                "root_form.hob.planet_ring", "root_form.shaper.planet_ring"}));
}

const ConstraintReport& named(const DesignReport& report, const std::string& name) {
  return *std::find_if(report.constraints.begin(), report.constraints.end(),
                       [&](const ConstraintReport& each) { return each.name == name; });
}

// Oracle: another program, 65 teeth in 155: hob 0.2965 at most, shaper of 30 teeth 0.2842, where
// the planet itself as a shaper would bear 0.4207; undercut below 2 (1.25 - 0.65798 rho)/sin^2(20).
TEST(PlanetaryEvaluate, JudgesTheRootFormOfStatedCutters) {
  Problem problem = stage();
  const Design design{{25, 65}, 3, Rational(3, 5)};
  const DesignReport assumed = planetary::evaluate(problem, design);
  EXPECT_NEAR(named(assumed, "root_form.hob.planet_ring").value, .6 * 0.2965, 1e-4);
  EXPECT_EQ(named(assumed, "root_form.hob.planet_ring").limit, 0);
  EXPECT_NEAR(named(assumed, "root_form.shaper.planet_ring").value, .6 * 0.4207, 1e-4);
  problem.cutters = {Rational(29, 100), Rational(14, 50), 30};
  const DesignReport borne = planetary::evaluate(problem, design);
  EXPECT_TRUE(named(borne, "root_form.hob.planet_ring").satisfied);
  EXPECT_TRUE(named(borne, "root_form.shaper.planet_ring").satisfied);
  EXPECT_NEAR(named(borne, "root_form.shaper.planet_ring").value, .6 * 0.2842, 1e-4);
  EXPECT_NEAR(named(borne, "undercut.sun").limit, 18.1092, 1e-4);
  problem.cutters = {Rational(3, 10), Rational(3, 10), 30};
  const DesignReport missed = planetary::evaluate(problem, design);
  for (const char* name : {"root_form.hob.planet_ring", "root_form.shaper.planet_ring"}) {
    EXPECT_FALSE(named(missed, name).satisfied) << name;
    EXPECT_NEAR(named(missed, name).margin, named(missed, name).value - .18, 1e-12);
    EXPECT_EQ(named(missed, name).sentence.rfind(std::string(name) + ": 0.1", 0), 0u);
  }
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
