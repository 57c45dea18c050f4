// SPDX-License-Identifier: Apache-2.0
#include "gearbox/synthesis/synthesis.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "gearbox/strength/problem_strength.hpp"
#include "gearbox/topologies/topology.hpp"
#include "tests/gearbox/synthesis/synthesis_example.hpp"
#include "tests/oracles/loaded_three_k.hpp"

namespace torquewright::gearbox {
namespace {

/// One module and planet count, and few teeth, so that a fine grid can walk through all of it.
nlohmann::json tiny_synthesis() {
  nlohmann::json root = test::small_synthesis();
  root["planet_count"] = 3;
  root["min_teeth"] = {{"sun", 50}, {"planet_1", 20}, {"planet_2", 16}};
  root["synthesis"]["gap"] = 0.002;
  return root;
}

// Oracle: evaluate and strength on a grid of centre distances and shifts of every choice of teeth
// that a triple loop finds. None may be lighter than the bound, and the best of the grid is hardly
// heavier than the optimum.
TEST(Synthesis, IsNotBeatenByAFineGrid) {
  const Problem problem = test::problem_from(tiny_synthesis());
  const SynthesisResult found = synthesise(problem);
  ASSERT_EQ(found.status, SynthesisStatus::kOptimal);
  const LayerModules modules = layer_modules(problem);
  double best_kg = 1e300;
  int designs = 0;
  for (const TrainChoice& choice : train_choices(problem, modules, 1000000)) {
    const InnerBox box = *inner_box(problem, inner_case(problem, modules, choice));
    constexpr int kSteps = 15;
    const auto at = [&](const Interval& range, int step) {
      return range.lower + (range.upper - range.lower) * step / kSteps;
    };
    for (int i = 0; i <= kSteps; ++i) {
      for (int j = 0; j <= kSteps; ++j) {
        for (int k = 0; k <= j; ++k) {
          const SizedDesign sized =
              sized_design(problem, modules, choice, {at(box[0], i), at(box[1], j), at(box[1], k)});
          if (!sized.objection.empty()) continue;
          best_kg = std::min(best_kg, sized.mass_kg);
          ++designs;
        }
      }
    }
  }
  EXPECT_GT(designs, 10);
  EXPECT_GE(best_kg, found.bound_kg);
  EXPECT_LT(best_kg, 1.1 * found.bound_kg);
}

/// Every choice of teeth by its definition: ratio, coaxiality within a tooth, equal spacing and
/// planets that are alike, minima, bore.
TEST(Synthesis, ChoosesAmongAllTeethThatMeetRatioAndAssembly) {
  const Problem problem = test::problem_from(test::small_synthesis());
  std::size_t expected = 0;
  for (std::int64_t n : {3, 4}) {
    for (std::int64_t s = 20; s <= 113; ++s) {
      for (std::int64_t p = 16; p <= 113; ++p) {
        for (std::int64_t f = s + 2 * p - 1; f <= s + 2 * p + 1 && f <= 113; ++f) {
          for (std::int64_t q = 14; q + n <= p; ++q) {
            for (std::int64_t o = s + p + q - 1; o <= s + p + q + 1; ++o) {
              if ((s + f) % n != 0 || (s + f) * p * o != 20 * s * (p * o - f * q)) continue;
              const double angle = std::asin(static_cast<double>(p) / static_cast<double>(s + p));
              if (std::numbers::pi / static_cast<double>(n) < angle) continue;
              if ((o * p - f * q) % (n * std::gcd(p, q)) == 0) ++expected;
            }
          }
        }
      }
    }
  }
  EXPECT_EQ(train_choices(problem, layer_modules(problem), 1000000).size(), expected);
  EXPECT_GT(expected, 5U);
}

// Oracle: evaluate and strength of the design as it is written.
TEST(Synthesis, AgreesWithEvaluateAndStrength) {
  const Problem problem = test::problem_from(test::small_synthesis());
  const SynthesisResult found = synthesise(problem);
  ASSERT_TRUE(found.best);
  Problem asked = problem;
  asked.face_width_mm = {{"layer_1", io::exact(found.best->face_width_mm[0])},
                         {"layer_2", io::exact(found.best->face_width_mm[1])}};
  const DesignReport report = find_topology("3k")->evaluate(asked, found.best->design);
  EXPECT_TRUE(report.feasible());
  EXPECT_NEAR(report.mass_kg.value(), found.best->mass_kg, 1e-12);
  const auto strength = strength_of_design(asked, found.best->design);
  ASSERT_TRUE(strength);
  EXPECT_TRUE(has_demanded_safety(*strength, tooth_loads(*strength, 120.0 / 20.0)));
  EXPECT_LE(found.bound_kg, found.best->mass_kg);
}

TEST(Synthesis, HasAValidBoundWhereverItIsEnded) {
  const Problem problem = test::problem_from(test::small_synthesis());
  const double optimum_kg = synthesise(problem).best->mass_kg;
  double before_kg = 0.0;
  for (const std::int64_t boxes : {1, 50, 200, 400}) {
    SynthesisOptions options;
    options.max_boxes = boxes;
    const SynthesisResult ended = synthesise(problem, options);
    EXPECT_LE(ended.bound_kg, optimum_kg);
    EXPECT_GE(ended.bound_kg, before_kg);
    before_kg = ended.bound_kg;
  }
}

/// No design is lighter than the bound, and the best is at most the gap of a thousandth heavier.
void expect_ends_as_the_enumeration(const nlohmann::json& root, std::int64_t boxes) {
  SynthesisOptions options;
  options.max_boxes = boxes;
  const SynthesisResult found = synthesise(test::problem_from(root), options);
  ASSERT_EQ(found.status, SynthesisStatus::kOptimal);
  const auto other = oracles::enumerate_loaded_trains(root, 14);
  ASSERT_TRUE(other.lightest);
  EXPECT_LE(found.bound_kg, other.lightest->mass_kg);
  EXPECT_LE(found.best->mass_kg, other.lightest->mass_kg * 1.001);
}

// The lightest lies in a sharp corner: the sun's shift at its least, the planet's tip at the end of
// the sun's involute. Oracle: an enumeration with grids and descents that shares no formula.
TEST(Synthesis, EndsWhereTheLightestLiesInACorner) {
  nlohmann::json root = test::small_stage();
  root["planet_count"] = 3;
  root["min_teeth"] = {{"sun", 26}, {"planet", 38}};
  expect_ends_as_the_enumeration(root, 1000);
}

// The lightest lies where three limits meet: both planets' shifts at their greatest, the sun's tip
// just clear of planet 2. Oracle: as above.
TEST(Synthesis, EndsWhereTheLightestLiesOnLimitsOfItsShifts) {
  nlohmann::json root = test::small_synthesis();
  root["target_ratio"] = 30;
  root["rotor_inner_diameter_mm"] = 71.6;
  root["module_mm"] = 0.4;
  root["planet_count"] = 3;
  root["min_teeth"] = {{"sun", 80}, {"planet_1", 32}, {"planet_2", 28}};
  root["load"] = {{"output_torque_Nm", 50}, {"cycles", 10000}};
  root["synthesis"]["max_profile_shift"] = 0.3;
  expect_ends_as_the_enumeration(root, 2000);
}

// Oracle: the same problem with each topology stated.
TEST(Synthesis, OfAnOpenTopologyIsTheLightestOfEachAndProvesAll) {
  const nlohmann::json open = test::small_open_problem();
  const SynthesisResult found = synthesise(test::problem_from(open));
  ASSERT_EQ(found.status, SynthesisStatus::kOptimal);
  ASSERT_EQ(found.topologies.size(), all_train_parts().size());
  double lightest_kg = 1e300, bound_kg = 1e300;
  int feasible = 0;
  for (const TopologyAnswer& answer : found.topologies) {
    const nlohmann::json stated = as_topology(open, train_parts(answer.topology));
    const SynthesisResult alone = synthesise(test::problem_from(stated));
    EXPECT_EQ(answer.status, alone.status) << answer.topology;
    EXPECT_EQ(answer.choices, alone.choices) << answer.topology;
    EXPECT_EQ(answer.bound_kg, alone.bound_kg) << answer.topology;
    bound_kg = std::min(bound_kg, alone.bound_kg);
    if (!alone.best) continue;
    ++feasible;
    EXPECT_EQ(answer.mass_kg, alone.best->mass_kg) << answer.topology;
    lightest_kg = std::min(lightest_kg, alone.best->mass_kg);
  }
  EXPECT_GE(feasible, 2);
  EXPECT_LT(feasible, 4);  // And of one it is proved that there is none.
  EXPECT_EQ(found.best->mass_kg, lightest_kg);
  EXPECT_EQ(found.bound_kg, bound_kg);
}

TEST(Synthesis, OfAnOpenTopologySharesItsBoxesAndKeepsAValidBound) {
  const Problem problem = test::problem_from(test::small_open_problem());
  const SynthesisResult whole = synthesise(problem);
  for (const std::int64_t boxes : {std::int64_t{1}, whole.boxes / 4, whole.boxes / 2}) {
    SynthesisOptions options;
    options.max_boxes = boxes;
    const SynthesisResult ended = synthesise(problem, options);
    EXPECT_EQ(ended.status, SynthesisStatus::kLimit) << boxes;
    EXPECT_LE(ended.bound_kg, whole.best->mass_kg) << boxes;
    EXPECT_LT(ended.boxes, whole.boxes);
  }
}

// Oracle: the same problem with a greater load, which asks the same of the teeth.
TEST(Synthesis, MakesTeethBearMoreThanTheLoad) {
  nlohmann::json root = test::small_synthesis();
  root["planet_count"] = 3;
  root["min_teeth"] = {{"sun", 50}, {"planet_1", 20}, {"planet_2", 16}};
  root["load"]["output_torque_Nm"] = 90;
  root["synthesis"]["min_torque_borne_Nm"] = 110;
  const SynthesisResult floored = synthesise(test::problem_from(root));
  root["synthesis"].erase("min_torque_borne_Nm");
  root["load"]["output_torque_Nm"] = 110;
  const SynthesisResult loaded = synthesise(test::problem_from(root));
  ASSERT_TRUE(floored.best && loaded.best);
  EXPECT_EQ(floored.best->mass_kg, loaded.best->mass_kg);
  EXPECT_EQ(floored.bound_kg, loaded.bound_kg);
  EXPECT_GE(floored.best->borne.joint_Nm, 110.0);
  const auto& constraints = floored.best->report.constraints;
  const auto own = std::find_if(constraints.begin(), constraints.end(),
                                [](const auto& each) { return each.name == "torque_borne"; });
  ASSERT_NE(own, constraints.end());
  EXPECT_EQ(own->limit, 110.0);
  EXPECT_TRUE(own->satisfied);
}

TEST(Synthesis, KeepsFloorsAndSaysWhereNoneIsLeft) {
  nlohmann::json root = test::small_synthesis();
  const SynthesisResult free = synthesise(test::problem_from(root));
  const double before = free.best->report.backward_efficiency;
  root["min_backward_efficiency"] = before + 0.004;
  const SynthesisResult floored = synthesise(test::problem_from(root));
  ASSERT_TRUE(floored.best);
  EXPECT_GE(floored.best->report.backward_efficiency, before + 0.004);
  EXPECT_GE(floored.best->mass_kg, free.bound_kg);
  root["min_backward_efficiency"] = 0.995;
  EXPECT_EQ(synthesise(test::problem_from(root)).status, SynthesisStatus::kInfeasible);
  root = test::small_synthesis();
  root["max_axial_length_mm"] = 5;
  EXPECT_EQ(synthesise(test::problem_from(root)).status, SynthesisStatus::kInfeasible);
}

}  // namespace
}  // namespace torquewright::gearbox
