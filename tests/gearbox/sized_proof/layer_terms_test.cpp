// SPDX-License-Identifier: Apache-2.0
// The formulas of the checker against `evaluate` and `strength`, and its enclosures against the
// formulas.
#include "gearbox/sized_proof/layer_terms.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "gearbox/sized_proof/layer_cell.hpp"
#include "gearbox/sized_proof/whole_choices.hpp"
#include "gearbox/strength/strength.hpp"
#include "gearbox/synthesis/sized_design.hpp"
#include "gearbox/teeth/tooth_geometry.hpp"
#include "tests/gearbox/synthesis/synthesis_example.hpp"

namespace torquewright::gearbox::sized {
namespace {

std::vector<nlohmann::json> examples() {
  nlohmann::json inert = test::small_synthesis();
  inert["rotor_inertia_kg_m2"] = 0.00001;
  inert["max_reflected_inertia_kg_m2"] = 0.0145;
  inert["min_backward_efficiency"] = 0.9;
  inert["min_hollow_shaft_diameter_mm"] = 8;
  return {test::small_synthesis(), inert, test::small_stage(), test::small_stepped("compound"),
          test::small_stepped("3k_b")};
}

struct Example {
  explicit Example(const nlohmann::json& root) : problem(test::problem_from(root)) {
    for_each_choice(problem, [&](const WholeNumbers& whole) {
      choices.push_back(whole);
      return true;
    });
    const Floors& floors = problem.floors;
    demands.inertia = floors.reflected_inertia_kg_m2.has_value();
    demands.efficiency = floors.backward_efficiency.has_value();
    demands.hollow_shaft_mm = as_number(floors.hollow_shaft_mm);
  }
  Problem problem;
  std::vector<WholeNumbers> choices;
  Demands demands;
};

TrainChoice as_searched(const WholeNumbers& whole) {
  return {{whole.sun, whole.planet[0], whole.planet[1], whole.ring[0], whole.ring[1]},
          whole.planets,
          {}};
}

/// Mass and inertia of what the formulas accept.
struct Weighed {
  bool exists = true;
  double kg = 0.0, kg_m2 = 0.0;
};

Weighed weigh_at(const Example& example, const LoadedTeeth& teeth,
                 const std::array<double, 3>& point) {
  Weighed sum;
  double length_mm = 0.0;
  for (std::size_t layer = 0; layer < (teeth.has_second_layer() ? 2U : 1U); ++layer) {
    const auto terms = layer_terms(teeth, layer, point[0], point[layer + 1], example.demands);
    for (const double margin : terms.margins) sum.exists = sum.exists && margin >= 0.0;
    double width_mm = 0.0;
    for (const double each : terms.width_mm) {
      if (!(each <= 1e9)) sum.exists = false;
      width_mm = std::max(width_mm, each);
    }
    if (width_mm > teeth.widest_mm[layer]) sum.exists = false;
    sum.kg += width_mm * terms.kg_per_mm;
    if (example.demands.inertia) sum.kg_m2 += width_mm * terms.kg_m2_per_mm;
    length_mm += width_mm;
  }
  if (teeth.is_sun_below && sun_clearance_mm(teeth, point[1], point[2]) < 0.0) sum.exists = false;
  return sum;
}

// Oracle: evaluate and strength of the same designs. Where they accept one, the formulas do, and
// weigh it alike, up to how closely places of a ring's root are sought.
TEST(LayerTerms, SayWhatEvaluateAndStrengthSay) {
  std::mt19937 generator(21);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  for (const nlohmann::json& root : examples()) {
    const Example example(root);
    Problem free = example.problem;  // Ceilings of the whole train are judged elsewhere.
    free.floors.reflected_inertia_kg_m2.reset();
    free.floors.backward_efficiency.reset();
    const LayerModules modules = layer_modules(free);
    int compared = 0, refused = 0, contradictions = 0;
    for (const WholeNumbers& whole : example.choices) {
      const LoadedTeeth teeth = loaded_teeth(example.problem, whole);
      const CentreRange centre = centre_range(teeth);
      for (int trial = 0; trial < 20; ++trial) {
        const auto shift = [&] {
          return teeth.least_shift + share(generator) * (teeth.greatest_shift - teeth.least_shift);
        };
        const std::array<double, 3> point{
            centre.low_mm + share(generator) * (centre.high_mm - centre.low_mm), shift(), shift()};
        TrainChoice choice = as_searched(whole);
        const auto& offered = free.module_mm;
        choice.module[0] = static_cast<std::size_t>(
            std::find(offered.begin(), offered.end(), whole.module_mm[0]) - offered.begin());
        const SizedDesign sized = sized_design(free, modules, choice, point);
        const Weighed weighed = weigh_at(example, teeth, point);
        if (weighed.exists != sized.objection.empty()) ++contradictions;
        if (!weighed.exists || !sized.objection.empty()) {
          ++refused;
          continue;
        }
        ++compared;
        EXPECT_NEAR(weighed.kg / sized.mass_kg, 1.0, 3e-3);
        EXPECT_LE(weighed.kg, sized.mass_kg * (1.0 + 1e-5));
        if (!example.demands.inertia) continue;
        const double own_kg_m2 = sized.report.reflected_inertia_kg_m2.value() -
                                 sized.report.rotor_inertia_at_output_kg_m2.value();
        EXPECT_NEAR(weighed.kg_m2 / own_kg_m2, 1.0, 3e-3);
      }
    }
    EXPECT_GT(compared, 5) << root["topology"];
    EXPECT_GT(refused, 10) << root["topology"];
    EXPECT_EQ(contradictions, 0) << root["topology"];
  }
}

/// A box around a point, which lies anywhere in it.
CellBox box_around(const std::array<double, 2>& point, double size, std::mt19937& generator) {
  std::uniform_real_distribution<double> part(0.0, size);
  return {Range{point[0] - part(generator), point[0] + part(generator)},
          Range{point[1] - part(generator), point[1] + part(generator)}};
}

// Oracle: the formulas at points of the box.
TEST(LayerTerms, AreEnclosed) {
  std::mt19937 generator(22);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  for (const nlohmann::json& root : examples()) {
    const Example example(root);
    int compared = 0, kept = 0;
    for (const WholeNumbers& whole : example.choices) {
      const LoadedTeeth teeth = loaded_teeth(example.problem, whole);
      const CentreRange centre = centre_range(teeth);
      for (int trial = 0; trial < 40; ++trial) {
        const std::size_t layer = teeth.has_second_layer() ? trial % 2 : 0;
        const std::array<double, 2> point{
            centre.low_mm + share(generator) * (centre.high_mm - centre.low_mm),
            teeth.least_shift + share(generator) * (teeth.greatest_shift - teeth.least_shift)};
        const CellBox box =
            box_around(point, std::pow(10.0, -3.0 * share(generator)) * 0.2, generator);
        const auto range = layer_terms(teeth, layer, variable(box[0].low, box[0].high, 0),
                                       variable(box[1].low, box[1].high, 1), example.demands);
        const auto at = layer_terms(teeth, layer, point[0], point[1], example.demands);
        double width_mm = 0.0;
        for (const double each : at.width_mm) width_mm = std::max(width_mm, each);
        const bool is_design = width_mm <= teeth.widest_mm[layer] &&
                               std::all_of(at.margins.begin(), at.margins.end(),
                                           [](double margin) { return margin >= 0.0; });
        EXPECT_FALSE(is_design && range.is_closed);
        for (std::size_t i = 0; i < std::min(range.margins.size(), at.margins.size()); ++i) {
          const Affine& margin = range.margins[i];
          if (!std::isfinite(at.margins[i]) || margin.is_nowhere()) continue;
          // Lists differ from where a shaper is not sure to exist.
          if (range.margins.size() != at.margins.size() && i + 1 >= range.margins.size()) continue;
          EXPECT_GE(at.margins[i], margin.low - 1e-10) << i;
          EXPECT_LE(at.margins[i], margin.high + 1e-10) << i;
          ++compared;
        }
        if (!is_design) continue;
        // No bound of a width is above what the design needs, and no cell loses the design.
        for (const Affine& each : range.width_mm) EXPECT_LE(each.low, width_mm * (1.0 + 1e-5));
        LayerCell cell{.box = box};
        const bool is_kept = bound_cell(teeth, layer, example.demands, {}, cell);
        ++kept;
        ASSERT_TRUE(is_kept);
        EXPECT_LE(cell.least_kg, width_mm * at.kg_per_mm * (1.0 + 1e-5));
        for (const std::size_t i : {0U, 1U}) {
          EXPECT_LE(cell.box[i].low, point[i]);
          EXPECT_GE(cell.box[i].high, point[i]);
        }
      }
    }
    EXPECT_GT(compared, 1000) << root["topology"];
    EXPECT_GT(kept, 10) << root["topology"];
  }
}

// What wide boxes rest on (layer_terms.cpp, is_ruled): the stress that sizes a root falls with the
// rounding of its hob.
TEST(LayerTerms, RestOnRootsThatARounderHobMakesStronger) {
  for (double teeth = 10; teeth <= 200; teeth *= 1.3) {
    for (double shift = -0.6; shift <= 1.1; shift += 0.1) {
      for (double tip = 0.7; tip <= 1.05; tip += 0.07) {
        const double diameter = teeth + 2.0 * (tip + shift);
        if (diameter <= teeth * kReferenceCosine) continue;
        double before = kInfinity;
        for (double radius = 0.0; radius <= 0.381; radius += 0.02) {
          const RootFactors root =
              din3990_root_factors(teeth, shift, diameter, 1.0, {1.25, radius});
          if (!(root.form > 0.0)) continue;
          EXPECT_LT(root.form * root.concentration, before) << teeth << " " << shift;
          before = root.form * root.concentration;
        }
      }
    }
  }
}

}  // namespace
}  // namespace torquewright::gearbox::sized
