// SPDX-License-Identifier: Apache-2.0
// The formulas of the synthesis against `evaluate` and `strength`, which were there before it, and
// its enclosures against the formulas.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "gearbox/strength/strength.hpp"
#include "gearbox/synthesis/inner_bound.hpp"
#include "gearbox/synthesis/sized_design.hpp"
#include "gearbox/teeth/tooth_geometry.hpp"
#include "tests/gearbox/synthesis/synthesis_example.hpp"

namespace torquewright::gearbox {
namespace {

struct InnerExample {
  explicit InnerExample(const nlohmann::json& root = test::small_synthesis())
      : problem(test::problem_from(root)) {}
  Problem problem;
  LayerModules modules = layer_modules(problem);
  std::vector<TrainChoice> choices = train_choices(problem, modules, 1000000);
};

std::array<double, 3> random_point(const InnerBox& box, std::mt19937& generator) {
  std::uniform_real_distribution<double> share(0.0, 1.0);
  const auto within = [&](const Interval& range) {
    return range.lower + share(generator) * (range.upper - range.lower);
  };
  return {within(box[0]), within(box[1]), within(box[1])};
}

/// With a ceiling on the inertia that some of its designs are above.
nlohmann::json with_ceiling() {
  nlohmann::json root = test::small_synthesis();
  root["rotor_inertia_kg_m2"] = 0.00001;
  root["max_reflected_inertia_kg_m2"] = 0.0145;
  return root;
}

double gear_inertia_kg_m2(const InnerCase& inner, const std::array<double, 3>& point) {
  double sum = 0.0;
  for (const std::size_t layer : {0U, 1U}) {
    const auto values = layer_values(inner, layer, point[0], point[layer + 1]);
    sum += *std::max_element(values.width_mm.begin(), values.width_mm.end()) *
           values.inertia_per_width_kg_m2_mm;
  }
  return sum;
}

// Oracle: evaluate and strength. Where both find a design, they weigh it alike, up to how closely
// eighths of a shaper's turn and a parabola find the worst section of a ring: never heavier than it
// is found there, but for the end of that search.
void expect_what_evaluate_says(const nlohmann::json& root, double of_rings = 2e-3) {
  const InnerExample example(root);
  ASSERT_GT(example.choices.size(), 3U);
  const double load_Nm = io::nearest(example.problem.load_output_torque_Nm.value());
  std::mt19937 generator(2);
  int compared = 0, contradictions = 0;
  for (const TrainChoice& choice : example.choices) {
    const InnerCase inner = inner_case(example.problem, example.modules, choice);
    const auto box = inner_box(example.problem, inner);
    ASSERT_TRUE(box);
    for (int trial = 0; trial < 100; ++trial) {
      const auto point = random_point(*box, generator);
      const auto mass_kg = mass_at(inner, point);
      const SizedDesign sized = sized_design(example.problem, example.modules, choice, point);
      if (mass_kg.has_value() != sized.objection.empty()) ++contradictions;
      if (!mass_kg || !sized.objection.empty()) continue;
      EXPECT_NEAR(*mass_kg / sized.mass_kg, 1.0, of_rings);
      EXPECT_LE(*mass_kg, sized.mass_kg * (1.0 + 1e-5));
      if (inner.max_gear_inertia_kg_m2) {
        const double rotor_kg_m2 = sized.report.rotor_inertia_at_output_kg_m2.value();
        EXPECT_NEAR((gear_inertia_kg_m2(inner, point) + rotor_kg_m2) /
                        sized.report.reflected_inertia_kg_m2.value(),
                    1.0, of_rings);
      }
      EXPECT_GE(sized.borne.joint_Nm, load_Nm);
      EXPECT_LT(sized.borne.joint_Nm, load_Nm + 0.01);
      ++compared;
    }
  }
  EXPECT_GT(compared, 20);
  EXPECT_EQ(contradictions, 0);
}

TEST(InnerValues, WeighWhatEvaluateAndStrengthSay) {
  expect_what_evaluate_says(test::small_synthesis());
}
TEST(InnerValues, WeighWhatEvaluateSaysOfASingleStage) {
  expect_what_evaluate_says(test::small_stage());
}
TEST(InnerValues, WeighWhatEvaluateSaysOfACompoundTrain) {
  expect_what_evaluate_says(test::small_stepped("compound"));
}
TEST(InnerValues, WeighWhatEvaluateSaysOfA3kTrainOfTypeB) {
  // Its planets bend one way: rings alone set its widths.
  expect_what_evaluate_says(test::small_stepped("3k_b"), 3e-3);
}
TEST(InnerValues, HaveTheInertiaThatEvaluateSays) { expect_what_evaluate_says(with_ceiling()); }

// Oracle: the formulas at points of the box. Every enclosure holds them, and the line that its
// slopes draw.
TEST(InnerValues, AreEnclosed) {
  const InnerExample example(with_ceiling());
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> size(0.001, 0.2);
  int compared = 0;
  for (const TrainChoice& choice : example.choices) {
    const InnerCase inner = inner_case(example.problem, example.modules, choice);
    const InnerBox whole = *inner_box(example.problem, inner);
    for (int trial = 0; trial < 20; ++trial) {
      const auto middle = random_point(whole, generator);
      const double half = size(generator);
      const InnerBox box{Interval{middle[0] - half * 0.5, middle[0] + half * 0.5},
                         Interval{middle[1] - half, middle[1] + half}};
      for (const std::size_t layer : {0U, 1U}) {
        const InnerPlace place(box);
        const auto range = layer_values(inner, layer, place, 1e9);
        std::uniform_real_distribution<double> along(-1.0, 1.0);
        const double centre_mm = middle[0] + half * 0.5 * along(generator);
        const double shift = middle[1] + half * along(generator);
        const auto at = layer_values(inner, layer, centre_mm, shift);
        const auto& inertia = range.inertia_per_width_kg_m2_mm.value;
        EXPECT_GE(at.inertia_per_width_kg_m2_mm, inertia.lower * (1.0 - 1e-12));
        EXPECT_LE(at.inertia_per_width_kg_m2_mm, inertia.upper * (1.0 + 1e-12));
        const std::vector<std::string> names = margin_names(inner, layer);
        for (std::size_t i = 0; i < range.margins.size(); ++i) {
          // Without a shaper that surely exists it has no enclosure, and 0 stands for it.
          if (names[i] == "root_form.shaper") continue;
          if (!std::isfinite(at.margins[i]) || !(range.margins[i].value.lower > -1e300)) continue;
          EXPECT_GE(at.margins[i], range.margins[i].value.lower - 1e-11) << i;
          EXPECT_LE(at.margins[i], range.margins[i].value.upper + 1e-11) << i;
          ++compared;
        }
      }
    }
  }
  EXPECT_GT(compared, 1000);
}

// Oracle: the formulas at points. No point of a box that is a design is lighter than the bound.
void expect_not_above_any_design(const nlohmann::json& root) {
  const InnerExample example(root);
  std::mt19937 generator(4);
  int designs = 0;
  for (const TrainChoice& choice : example.choices) {
    const InnerCase inner = inner_case(example.problem, example.modules, choice);
    const InnerBox whole = *inner_box(example.problem, inner);
    for (int trial = 0; trial < 200; ++trial) {
      const auto point = random_point(whole, generator);
      const auto mass_kg = mass_at(inner, point);
      if (!mass_kg) continue;
      // The point lies anywhere in the box, not at its middle.
      const double half = 0.1 * (trial % 5);
      std::uniform_real_distribution<double> part(0.0, half);
      InnerNode node{Interval{point[0] - part(generator), point[0] + part(generator)}, {}};
      for (const std::size_t layer : {0U, 1U}) {
        const double shift = point[layer + 1];
        node.cells[layer].push_back(
            {.box = {node.centre_mm,
                     Interval{shift - 2.0 * part(generator), shift + 2.0 * part(generator)}}});
      }
      const InnerBound bound = bound_inner(inner, optimization::kInfinity, node);
      EXPECT_FALSE(bound.is_empty);
      EXPECT_LE(bound.mass_kg, *mass_kg * (1.0 + 1e-9));
      for (const std::size_t layer : {0U, 1U}) {
        const auto& cells = node.cells[layer];
        EXPECT_TRUE(std::any_of(cells.begin(), cells.end(),
                                [&](const LayerCell& cell) {
                                  return cell.box[0].contains(point[0]) &&
                                         cell.box[1].contains(point[layer + 1]);
                                }))
            << "layer " << layer << ": the design is cut off";
      }
      ++designs;
    }
  }
  EXPECT_GT(designs, 50);
}

TEST(InnerBound, IsNotAboveAnyDesign) { expect_not_above_any_design(test::small_synthesis()); }
TEST(InnerBound, IsNotAboveAnyDesignOfASingleStage) {
  expect_not_above_any_design(test::small_stage());
}
TEST(InnerBound, IsNotAboveAnyDesignOfACompoundTrain) {
  expect_not_above_any_design(test::small_stepped("compound"));
}
TEST(InnerBound, IsNotAboveAnyDesignOfA3kTrainOfTypeB) {
  expect_not_above_any_design(test::small_stepped("3k_b"));
}
TEST(InnerBound, IsNotAboveAnyDesignBelowACeiling) { expect_not_above_any_design(with_ceiling()); }

// What wide boxes rest on: the stress that a root is sized by falls with the rounding of its tool.
TEST(InnerBound, RestsOnRootsThatARounderToolMakesStronger) {
  for (double teeth = 10; teeth <= 200; teeth *= 1.25) {
    for (double shift = -0.6; shift <= kGreatestRuledShift; shift += 0.05) {
      for (double tip = 0.7; tip <= 1.05; tip += 0.05) {
        const double diameter = teeth + 2.0 * (tip + shift);
        if (diameter <= teeth * kReferenceCosine) continue;
        double before = 1e300;
        for (double radius = 0.0; radius <= 0.381; radius += 0.02) {
          const RootFactors root =
              din3990_root_factors(teeth, shift, diameter, 1.0, {1.25, radius});
          if (!(root.form > 0.0)) continue;
          const double asked = root.form * root.concentration;
          EXPECT_LT(asked, before) << teeth << " " << shift << " " << tip << " " << radius;
          before = asked;
        }
      }
    }
  }
}

}  // namespace
}  // namespace torquewright::gearbox
