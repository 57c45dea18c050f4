// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "gearbox/sized_proof/sized_proof.hpp"
#include "gearbox/sized_proof/soft_layers.hpp"
#include "gearbox/strength/mesh_stiffness.hpp"
#include "gearbox/strength/problem_strength.hpp"
#include "gearbox/synthesis/stiff_widths.hpp"
#include "gearbox/synthesis/synthesis.hpp"
#include "tests/gearbox/synthesis/synthesis_example.hpp"

namespace torquewright::gearbox {
namespace {

using nlohmann::json;

/// The least weight over many widths of the first layer, the second as narrow as it may be.
double least_of_many(const std::array<LayerWidth, 2>& layers, double most_rad_Nm) {
  double least = 1e300;
  constexpr int kSteps = 20000;
  const auto& [first, second] = layers;
  for (int i = 0; i <= kSteps; ++i) {
    const double width_mm = first.least_mm + (first.most_mm - first.least_mm) * i / kSteps;
    const double left = most_rad_Nm - first.softness / width_mm;
    if (!(left > 0.0)) continue;
    const double beside_mm = std::max(second.least_mm, second.softness / left);
    if (beside_mm > second.most_mm) continue;
    least = std::min(least, first.weight * width_mm + second.weight * beside_mm);
  }
  return least;
}

// Oracle: a fine grid. The search's closed form meets it, the proof's duality bounds it closely.
TEST(StiffWidths, WeighLeast) {
  std::mt19937 generator(3);
  const auto draw = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(generator()) * 0x1p-32;
  };
  int with_widths = 0, without = 0;
  for (int trial = 0; trial < 200; ++trial) {
    std::array<LayerWidth, 2> layers;
    for (LayerWidth& each : layers) {
      each = {draw(1, 8), draw(8, 20), draw(1e-5, 1e-4), draw(0.005, 0.03)};
    }
    const double most_rad_Nm = draw(2e-6, 4e-5);
    const double found = least_weight(layers, most_rad_Nm);
    std::array<sized::SoftLayer, 2> soft;
    for (std::size_t i = 0; i < 2; ++i) {
      soft[i] = {layers[i].least_mm, layers[i].most_mm, layers[i].softness, layers[i].weight};
    }
    const double proved = sized::least_sum(soft, 1.0 / most_rad_Nm);
    const double expected = least_of_many(layers, most_rad_Nm);
    if (expected > 1e299) {
      EXPECT_EQ(std::isinf(proved), std::isinf(found));
      ++without;
      continue;
    }
    ++with_widths;
    EXPECT_LE(found, expected * (1.0 + 1e-9));
    EXPECT_GE(found, expected * (1.0 - 1e-3));
    EXPECT_LE(proved, found * (1.0 + 1e-9));
    EXPECT_GE(proved, found * (1.0 - 1e-6));
  }
  EXPECT_GT(with_widths, 50);
  EXPECT_GT(without, 10);
}

/// The lightest of a grid of centre distances, shifts and widths that is stiff enough.
double lightest_of_grid_kg(const json& root, double least_Nm_rad) {
  const Problem problem = test::problem_from(root);
  const LayerModules modules = layer_modules(problem);
  double best_kg = 1e300;
  for (const TrainChoice& choice : train_choices(problem, modules, 1000)) {
    const InnerBox box = *inner_box(problem, inner_case(problem, modules, choice));
    constexpr int kSteps = 12;
    const auto at = [&](const Interval& range, int step) {
      return range.lower + (range.upper - range.lower) * step / kSteps;
    };
    for (int i = 0; i <= kSteps; ++i) {
      for (int j = 0; j <= kSteps; ++j) {
        const SizedDesign loaded =
            sized_design(problem, modules, choice, {at(box[0], i), at(box[1], j), 0.0});
        if (!loaded.objection.empty()) continue;
        for (int k = 0; k < 100; ++k) {
          Problem wide = loaded.problem;
          const double width_mm = loaded.face_width_mm[0] * (1.0 + 0.02 * k);
          if (width_mm > io::nearest(greatest_face_widths_mm(problem, loaded.design)[0])) break;
          wide.face_width_mm["layer_1"] = io::exact(width_mm);
          const auto strength = strength_of_design(wide, loaded.design);
          if (torsional_stiffness_Nm_rad(*strength) < least_Nm_rad) continue;
          best_kg = std::min(best_kg, loaded.mass_kg * (1.0 + 0.02 * k));
          break;
        }
      }
    }
  }
  return best_kg;
}

json one_stage() {
  json root = test::small_stage();
  root["planet_count"] = 3;
  root["ratio_tolerance"] = 0;
  root["min_teeth"] = {{"sun", 21}, {"planet", 16}};
  return root;
}

TEST(Synthesis, WidensFacesUntilTheyAreStiff) {
  json root = one_stage();
  const SynthesisResult free = synthesise(test::problem_from(root));
  const double asked_Nm_rad = 1.3 * free.best->stiffness_Nm_rad;
  const double grid_kg = lightest_of_grid_kg(root, asked_Nm_rad);
  root["synthesis"]["min_stiffness_Nm_rad"] = asked_Nm_rad;
  const Problem problem = test::problem_from(root);
  const SynthesisResult stiff = synthesise(problem);
  ASSERT_EQ(stiff.status, SynthesisStatus::kOptimal);
  EXPECT_GE(stiff.best->stiffness_Nm_rad, asked_Nm_rad);
  EXPECT_GT(stiff.best->mass_kg, free.best->mass_kg * 1.05);
  EXPECT_LE(stiff.bound_kg, grid_kg);
  EXPECT_LE(stiff.best->mass_kg, grid_kg * 1.001);
  EXPECT_GT(stiff.best->mass_kg, grid_kg * 0.9);
  sized::ProofEffort effort;
  EXPECT_TRUE(sized::prove_lightest(problem, stiff.bound_kg, effort).holds);
  EXPECT_FALSE(sized::prove_lightest(problem, stiff.best->mass_kg * 1.002, effort).holds);
  root["synthesis"]["min_stiffness_Nm_rad"] = 1e7;
  const Problem too_stiff = test::problem_from(root);
  EXPECT_EQ(synthesise(too_stiff).status, SynthesisStatus::kInfeasible);
  EXPECT_TRUE(sized::prove_lightest(too_stiff, INFINITY, effort).holds);
}

/// Of two layers, which share what is asked.
TEST(Synthesis, WidensTwoLayersUntilTheyAreStiffTogether) {
  json root = test::small_synthesis();
  root["planet_count"] = 3;
  root["min_teeth"] = {{"sun", 50}, {"planet_1", 20}, {"planet_2", 16}};
  root["synthesis"]["gap"] = 0.01;
  const SynthesisResult free = synthesise(test::problem_from(root));
  root["synthesis"]["min_stiffness_Nm_rad"] = 1.15 * free.best->stiffness_Nm_rad;
  const Problem problem = test::problem_from(root);
  SynthesisOptions options;
  options.max_boxes = 20000;
  const SynthesisResult stiff = synthesise(problem, options);
  ASSERT_EQ(stiff.status, SynthesisStatus::kOptimal);
  EXPECT_GE(stiff.best->stiffness_Nm_rad, 1.15 * free.best->stiffness_Nm_rad);
  EXPECT_GT(stiff.bound_kg, free.bound_kg);
  sized::ProofEffort effort;
  EXPECT_TRUE(sized::prove_lightest(problem, stiff.bound_kg, effort).holds);
}

}  // namespace
}  // namespace torquewright::gearbox
