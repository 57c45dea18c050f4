// SPDX-License-Identifier: Apache-2.0
// Random problems with `synthesis` against an enumeration of whole numbers with fine grids and
// descents within (tests/oracles/loaded_three_k), which shares no formula with the search.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "gearbox/synthesis/synthesis.hpp"
#include "tests/gearbox/synthesis/synthesis_example.hpp"
#include "tests/long_run.hpp"
#include "tests/oracles/loaded_three_k.hpp"

namespace torquewright::gearbox {
namespace {

using nlohmann::json;

/// Few choices of teeth, one of them near.
json random_synthesis(std::mt19937& generator, const std::string& topology) {
  const bool is_planetary = topology == "planetary";
  const auto among = [&](int low, int high) {
    return low + static_cast<int>(generator() % static_cast<unsigned>(high - low + 1));
  };
  json problem{{"kind", "gearbox_problem"}, {"version", 1}, {"topology", topology}};
  problem["target_ratio"] = is_planetary             ? among(30, 90) / 10.0
                            : topology == "compound" ? among(50, 140) / 10.0
                                                     : among(8, 40);
  problem["ratio_tolerance"] = among(0, 3) / 1000.0;
  problem["rotor_inner_diameter_mm"] = among(50, 90);
  problem["module_mm"] = among(5, 10) / 10.0;
  problem["planet_count"] = among(3, 5);
  problem["min_teeth"] = {
      {"sun", among(14, 40)}, {"planet_1", among(14, 20)}, {"planet_2", among(12, 16)}};
  if (is_planetary) problem["min_teeth"] = {{"sun", among(12, 24)}, {"planet", among(12, 20)}};
  problem["load"] = {{"output_torque_Nm", among(2, 25) * 10},
                     {"cycles", std::llround(std::pow(10.0, among(3, 7)))}};
  problem["synthesis"] = {{"ring_teeth_off", among(0, 1)}};
  if (among(0, 3) == 0 && !is_planetary) problem["synthesis"]["layer_2_module_mm"] = {0.6, 0.8};
  if (among(0, 2) == 0) problem["min_hollow_shaft_diameter_mm"] = among(5, 15);
  if (among(0, 2) == 0) problem["max_axial_length_mm"] = among(12, 30);
  if (among(0, 3) == 0) problem["min_backward_efficiency"] = among(88, 94) / 100.0;
  if (among(0, 2) == 0) problem["sun_under_second_layer"] = false;
  // Far enough from the defaults that they bind.
  if (among(0, 1) == 0) problem["synthesis"]["min_tip_thickness"] = among(4, 7) / 10.0;
  if (among(0, 1) == 0) problem["min_contact_ratio"] = among(14, 17) / 10.0;
  assume_for_synthesis(problem);
  return problem;
}

/// Ceilings just above or just below what the lightest train has.
void ask_ceilings(std::mt19937& generator, const SynthesisResult& free, json& problem) {
  const DesignReport& report = free.best->report;
  const auto near = [&](double value) {
    return value * (0.96 + 0.01 * static_cast<double>(generator() % 8));
  };
  if (generator() % 2 == 0) {
    problem["max_reflected_inertia_kg_m2"] = near(report.reflected_inertia_kg_m2.value());
  }
  if (generator() % 3 == 0)
    problem["max_backlash_rad_per_mm"] = near(report.output_backlash_rad_per_mm);
  if (generator() % 3 == 0) problem["max_mass_kg"] = near(free.best->mass_kg);
}

void expect_as_light_as_enumerated(const std::string& topology, bool has_ceilings) {
  const bool is_long = torquewright::test::is_long_run();
  const int wanted = is_long ? 200 : topology != "3k" || has_ceilings ? 1 : 2;
  const bool is_single = topology == "planetary";
  const std::int64_t most_choices = is_long ? 40 : topology == "3k" || is_single ? 3 : 1;
  std::mt19937 generator(is_long ? 7 : 12);
  int compared = 0;
  while (compared < wanted) {
    json root = random_synthesis(generator, topology);
    Problem problem = test::problem_from(root);
    const auto choices = train_choices(problem, layer_modules(problem), 100000).size();
    if (choices == 0 || static_cast<std::int64_t>(choices) > most_choices) continue;
    if (has_ceilings) {
      const SynthesisResult free = synthesise(problem);
      if (!free.best) continue;
      ask_ceilings(generator, free, root);
      problem = test::problem_from(root);
    }
    const SynthesisResult found = synthesise(problem);
    const oracles::LoadedTrains other = oracles::enumerate_loaded_trains(root, is_long ? 30 : 14);
    EXPECT_EQ(found.choices, other.choices) << root;
    // A grid may miss what the search finds; evaluate and strength have accepted it.
    if (!other.lightest) continue;
    ++compared;
    ASSERT_TRUE(found.best) << "a false infeasible: " << root;
    // Both search the ring's worst section, and the optimum is within the gap.
    EXPECT_LE(found.best->mass_kg, other.lightest->mass_kg * 1.0012) << root;
    EXPECT_LE(found.bound_kg, other.lightest->mass_kg * 1.0002) << root;
  }
}

TEST(Synthesis, ChoosesAmongAllTeethOfEveryTopology) {
  std::mt19937 generator(5);
  for (const TrainParts& parts : all_train_parts()) {
    std::size_t most = 0;
    for (int trial = 0; trial < 12; ++trial) {
      json root = random_synthesis(generator, std::string(parts.name));
      root["ratio_tolerance"] = 0.02;
      if (trial % 3 == 0) root["max_backlash_rad_per_mm"] = 0.3;
      const Problem problem = test::problem_from(root);
      const auto choices = train_choices(problem, layer_modules(problem), 1000000).size();
      EXPECT_EQ(choices, oracles::count_loaded_choices(root)) << root;
      most = std::max(most, choices);
    }
    EXPECT_GT(most, 5U) << parts.name;
  }
}

TEST(Synthesis, IsAsLightAsAFineEnumeration) { expect_as_light_as_enumerated("3k", false); }
TEST(Synthesis, IsAsLightWithCeilings) {
  if (!torquewright::test::is_long_run()) GTEST_SKIP() << torquewright::test::kLeftOut;
  expect_as_light_as_enumerated("3k", true);
}
TEST(Synthesis, OfASingleStageIsAsLightAsAFineEnumeration) {
  expect_as_light_as_enumerated("planetary", false);
}
TEST(Synthesis, OfASingleStageIsAsLightWithCeilings) {
  expect_as_light_as_enumerated("planetary", true);
}
TEST(Synthesis, OfACompoundTrainIsAsLightAsAFineEnumeration) {
  expect_as_light_as_enumerated("compound", false);
}
TEST(Synthesis, OfACompoundTrainIsAsLightWithCeilings) {
  expect_as_light_as_enumerated("compound", true);
}
TEST(Synthesis, OfA3kTrainOfTypeBIsAsLightAsAFineEnumeration) {
  expect_as_light_as_enumerated("3k_b", false);
}
TEST(Synthesis, OfA3kTrainOfTypeBIsAsLightWithCeilings) {
  expect_as_light_as_enumerated("3k_b", true);
}

}  // namespace
}  // namespace torquewright::gearbox
