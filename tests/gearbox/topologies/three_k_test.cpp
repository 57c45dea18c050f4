// SPDX-License-Identifier: Apache-2.0
#include "gearbox/topologies/three_k.hpp"

#include <gtest/gtest.h>

#include <array>

#include "gearbox/topologies/short_loss_form.hpp"
#include "tests/gearbox/example_problem.hpp"

namespace torquewright::gearbox {
namespace {

DesignReport evaluate_knee(const Problem& problem) {
  return three_k::evaluate(problem, {{44, 44, 32}, 4, Rational(3, 5)});
}

// Oracle: reference section 12, a table made with the short form: D151 at mu = 0.08.
TEST(ShortLossForm, IsThatOfPublishedTables) {
  const TrainEfficiency other = short_form_efficiency("3k", evaluate_knee(test::knee()));
  EXPECT_NEAR(other.forward, .95662, 5.001e-6);
  EXPECT_NEAR(other.backward, .95505, 5.001e-6);
}

TEST(ThreeKEvaluate, PublishedKneeIsFeasibleAsPrinted) {
  const DesignReport report = evaluate_knee(test::knee());
  EXPECT_TRUE(report.feasible());
  EXPECT_EQ(report.design.teeth, (std::vector<std::int64_t>{44, 44, 32, 132, 120}));
  EXPECT_EQ(report.ratio, Rational(20));
  EXPECT_EQ(report.planet_types, 1);
  EXPECT_NEAR(report.objective, 17360.1116, 5e-5);  // seed 001 eq. (1) in the contract
  EXPECT_NEAR(report.forward_efficiency, .9568, 5e-5);
  EXPECT_NEAR(report.backward_efficiency, .9552, 5e-5);
  EXPECT_NEAR(*report.input_torque_Nm, 16, 1e-12);
  EXPECT_NEAR(*report.fixed_ring_torque_Nm, 304, 1e-12);
  EXPECT_NEAR(*report.planet_tilting_force_N, 2222, .5);
  EXPECT_NEAR(report.meshes[0].tangential_force_N, 303, .5);
  EXPECT_NEAR(report.meshes[1].tangential_force_N, 1919, .5);
  EXPECT_NEAR(report.hollow_shaft_diameter_mm, 22.2,
              1e-12);  // 24.9, reference section 10, less a rim
  EXPECT_NEAR(report.gears[1].speed_per_input, -.5, 1e-15);  // reference section 9
  EXPECT_NEAR(report.carrier_speed_per_input, .25, 1e-15);
  EXPECT_NEAR(report.gears[4].speed_per_input, .05, 1e-15);
  EXPECT_FALSE(report.mass_kg);
  // The set "paper" of docs/gearbox_constraints.md, equations (4) to (9), and nothing else.
  std::vector<std::string> names;
  for (const ConstraintReport& constraint : report.constraints) names.push_back(constraint.name);
  EXPECT_EQ(names, (std::vector<std::string>{"ratio", "min_teeth.sun", "min_teeth.planet_1",
                                             "min_teeth.planet_2", "carrier_clearance",
                                             "rotor_bore", "tooth_difference", "equal_spacing"}));
}

TEST(ThreeKEvaluate, SharesSumToOne) {
  const DesignReport report = evaluate_knee(test::knee());
  double losses = 0;
  double backlash = 0;
  for (const MeshReport& mesh : report.meshes) {
    losses += mesh.loss_share;
    backlash += mesh.backlash_share;
  }
  EXPECT_NEAR(losses, 1, 1e-14);
  EXPECT_NEAR(backlash, 1, 1e-14);
  EXPECT_NEAR(report.meshes[2].backlash_share, .50, 5e-3);  // reference section 10
  EXPECT_NEAR(report.meshes[0].backlash_share, .07, 5e-3);
}

// Reference section 11: printed costs and efficiencies of single designs at 20:1, mu = .08.
struct Published {
  std::int64_t planet_count;
  std::array<std::int64_t, 5> teeth;
  double cost;  ///< 0: not printed.
  double forward, backward;
};

TEST(ThreeKEvaluate, PublishedCostsAndEfficiencies) {
  const std::vector<Published> designs{{3, {12, 24, 14, 60, 50}, 8504.118, 0, 0},
                                       {3, {12, 60, 16, 132, 88}, 0, .9730, .9727},
                                       {3, {66, 24, 20, 114, 110}, 0, .8940, 0},
                                       {4, {16, 30, 18, 76, 64}, 8493.448, 0, 0},
                                       {4, {24, 48, 28, 120, 100}, 0, .9676, .9670},
                                       {4, {54, 30, 24, 114, 108}, 0, .9238, 0},
                                       {4, {28, 24, 18, 76, 70}, 8973.446, 0, 0},
                                       {4, {44, 44, 32, 132, 120}, 17360.112, .9568, .9552}};
  for (const Published& row : designs) {
    const std::vector<std::int64_t> teeth(row.teeth.begin(), row.teeth.end());
    const DesignReport report =
        three_k::evaluate(test::knee(), {teeth, row.planet_count, Rational(3, 5)});
    EXPECT_EQ(report.ratio, Rational(20));
    EXPECT_EQ(report.planet_types, 1);
    EXPECT_EQ(test::find(report, "coaxial.fixed_ring"), nullptr);
    if (row.cost > 0) {
      EXPECT_NEAR(report.objective, row.cost, 5e-4);
    }
    if (row.forward > 0) {
      EXPECT_NEAR(report.forward_efficiency, row.forward, 5.001e-5) << teeth[0];
    }
    if (row.backward > 0) {
      EXPECT_NEAR(report.backward_efficiency, row.backward, 5.001e-5) << teeth[0];
    }
  }
}

TEST(ThreeKEvaluate, BuildableListsEveryConstraintInOrder) {
  Problem problem = test::knee();
  problem.constraints = ConstraintSet::kBuildable;
  problem.ring_outer_diameter_mm = Rational(90);
  const DesignReport report = evaluate_knee(problem);
  const std::vector<std::string> names{"ratio",
                                       "min_teeth.sun",
                                       "min_teeth.planet_1",
                                       "min_teeth.planet_2",
                                       "carrier_clearance",
                                       "rotor_bore",
                                       "tooth_difference",
                                       "equal_spacing",
                                       "identical_planets",
                                       "neighbour_clearance.layer_1",
                                       "neighbour_clearance.layer_2",
                                       "undercut.sun",
                                       "undercut.planet_1",
                                       "undercut.planet_2",
                                       "sun_under_layer_2",
                                       "ring_wall.fixed_ring",
                                       "ring_wall.output_ring",
                                       "ring_tip.fixed_ring",
                                       "ring_tip.output_ring",
                                       "interference.involute.planet_1_fixed_ring",
                                       "interference.involute.planet_2_output_ring",
                                       "interference.trochoid.planet_1_fixed_ring",
                                       "interference.trochoid.planet_2_output_ring",
                                       "contact_ratio.sun_planet_1",
                                       "contact_ratio.planet_1_fixed_ring",
                                       "contact_ratio.planet_2_output_ring",
                                       "root_form.hob.sun_planet_1",
                                       "root_form.hob.planet_1_fixed_ring",
                                       "root_form.hob.planet_2_output_ring",
                                       "root_form.shaper.planet_1_fixed_ring",
                                       "root_form.shaper.planet_2_output_ring"};
  ASSERT_EQ(report.constraints.size(), names.size());
  for (std::size_t index = 0; index < names.size(); ++index) {
    EXPECT_EQ(report.constraints[index].name, names[index]);
    EXPECT_TRUE(report.constraints[index].satisfied) << report.constraints[index].sentence;
    EXPECT_EQ(report.constraints[index].sentence.rfind(names[index] + ": ", 0), 0u);
  }
}

TEST(ThreeKEvaluate, ObjectivesStateTheirUnit) {
  Problem problem = test::knee();
  problem.face_width_mm = {{"layer_1", Rational(8)}, {"layer_2", Rational(8)}};
  problem.density_kg_m3 = Rational(7850);
  problem.rotor_inertia_kg_m2 = Rational(922, 1000000);
  const std::vector<std::pair<Objective, std::string>> units{
      {Objective::kPaperCost, "1"},          {Objective::kMass, "kg"},
      {Objective::kHollowShaft, "mm"},       {Objective::kForwardEfficiency, "1"},
      {Objective::kBackwardEfficiency, "1"}, {Objective::kReflectedInertia, "kg m^2"}};
  for (const auto& [objective, unit] : units) {
    problem.objective = objective;
    const DesignReport report = evaluate_knee(problem);
    EXPECT_EQ(report.objective_unit, unit);
    EXPECT_GT(report.objective, 0);
  }
  // Oracle: a separate program in Python, from the formula of docs/gearbox_constraints.md: the
  // rotor alone has 400 * 0.000922 = 0.3688.
  EXPECT_NEAR(*evaluate_knee(problem).reflected_inertia_kg_m2, 0.3746373135875242, 1e-14);
}

TEST(ThreeKEvaluate, AbsurdDesignsYieldNoNanAndNoInfinity) {
  Problem problem = test::knee();
  problem.constraints = ConstraintSet::kBuildable;
  problem.ring_outer_diameter_mm = Rational(90);
  problem.face_width_mm = {{"layer_1", Rational(8)}, {"layer_2", Rational(8)}};
  problem.density_kg_m3 = Rational(7850);
  const std::array<std::int64_t, 5> counts{1, 2, 5, 40, 300};
  for (const std::int64_t sun : counts) {
    for (const std::int64_t planet_1 : counts) {
      for (const std::int64_t planet_2 : counts) {
        for (const std::int64_t planets : {1, 6, 100}) {
          const Design design{{sun, planet_1, planet_2}, planets, Rational(3, 5)};
          EXPECT_TRUE(test::is_finite(three_k::evaluate(problem, design)))
              << sun << " " << planet_1 << " " << planet_2;
          for (const std::int64_t ring : counts) {
            const Design given{{sun, planet_1, planet_2, ring, 40}, planets, Rational(3, 5)};
            EXPECT_TRUE(test::is_finite(three_k::evaluate(problem, given)))
                << sun << " " << planet_1 << " " << planet_2 << " " << ring;
          }
        }
      }
    }
  }
}

TEST(ThreeKEvaluate, EqualPlanetsHaveNoRatioAndSaySo) {
  const DesignReport report = three_k::evaluate(test::knee(), {{44, 44, 44}, 4, Rational(3, 5)});
  const ConstraintReport* ratio = test::find(report, "ratio");
  EXPECT_FALSE(ratio->satisfied);
  EXPECT_LT(ratio->margin, 0);
  EXPECT_NE(ratio->sentence.find("does not exist"), std::string::npos);
  EXPECT_EQ(report.forward_efficiency, 0);
  EXPECT_FALSE(report.input_torque_Nm);
  EXPECT_NE(test::find_remark(report, "efficiency"), nullptr);
}

TEST(ThreeKEvaluate, ReversedOutputHasANegativeRatio) {
  // P1 < P2: 2 P1 O/(S (P1 - P2)) with 32, 44: 2*32*120/(44*-12)
  const DesignReport report = three_k::evaluate(test::knee(), {{44, 32, 44}, 4, Rational(3, 5)});
  EXPECT_EQ(report.ratio, Rational(-160, 11));
  EXPECT_FALSE(test::find(report, "ratio")->satisfied);
  EXPECT_GT(report.forward_efficiency, 0);
  EXPECT_LT(report.forward_efficiency, 1);
}

TEST(ThreeKEvaluate, PaperSetRemarksWhatCannotBeBuilt) {
  // Reference section 3: equation (4) holds, two planet types are needed.
  const DesignReport report = three_k::evaluate(test::knee(), {{44, 42, 31}, 4, Rational(3, 5)});
  EXPECT_TRUE(test::find(report, "equal_spacing")->satisfied);
  EXPECT_EQ(report.planet_types, 2);
  ASSERT_NE(test::find_remark(report, "identical_planets"), nullptr);
  EXPECT_NE(test::find_remark(report, "clocking"), nullptr);
}

}  // namespace
}  // namespace torquewright::gearbox
