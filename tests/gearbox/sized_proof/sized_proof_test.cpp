// SPDX-License-Identifier: Apache-2.0
// Oracle: an enumeration of whole numbers with fine grids within (tests/oracles/loaded_three_k),
// which shares no formula with the proof. What is lighter than its best is proved to be none; what
// is as light is not.
#include "gearbox/sized_proof/sized_proof.hpp"

#include <gtest/gtest.h>

#include "gearbox/sized_proof/enclosures/affine.hpp"
#include "gearbox/sized_proof/whole_choices.hpp"
#include "tests/gearbox/synthesis/synthesis_example.hpp"
#include "tests/long_run.hpp"
#include "tests/oracles/loaded_three_k.hpp"

namespace torquewright::gearbox::sized {
namespace {

using nlohmann::json;

json with(json problem, const json& changes) {
  problem.merge_patch(changes);
  return problem;
}

/// Few choices of each topology, with and without floors that bind.
std::vector<json> proved_examples() {
  const json one{{"planet_count", 3}, {"min_teeth", {{"sun", 50}, {"planet_1", 20}}}};
  const auto least = [](int sun, int planet_1) {
    return json{{"min_teeth", {{"sun", sun}, {"planet_1", planet_1}}}};
  };
  return {with(test::small_synthesis(), one),
          with(test::small_synthesis(), with(one, {{"min_backward_efficiency", 0.93}})),
          with(test::small_synthesis(),
               with(one, {{"min_hollow_shaft_diameter_mm", 31.5}, {"max_axial_length_mm", 20.5}})),
          with(test::small_stage(),
               {{"planet_count", 3}, {"ratio_tolerance", 0}, {"min_teeth", {{"sun", 21}}}}),
          with(test::small_stepped("compound"), least(24, 45)),
          with(test::small_stepped("3k_b"), least(68, 22))};
}

TEST(SizedProof, HoldsBelowTheBestOfAnEnumerationAndNotAboveIt) {
  const bool is_long = torquewright::test::is_long_run();
  int with_designs = 0;
  for (std::size_t i = 0; i < proved_examples().size(); i += is_long ? 1 : 6) {
    const json root = proved_examples()[i];
    const Problem problem = test::problem_from(root);
    const oracles::LoadedTrains other = oracles::enumerate_loaded_trains(root, is_long ? 16 : 6);
    ProofEffort effort;
    if (!other.lightest) continue;
    ++with_designs;
    const double best_kg = other.lightest->mass_kg;
    // The optimum is within what the grid's descent leaves of it.
    const SizedProof below = prove_lightest(problem, (is_long ? 0.996 : 0.98) * best_kg, effort);
    EXPECT_TRUE(below.holds) << root;
    EXPECT_EQ(below.choices, other.choices) << root;
    EXPECT_FALSE(effort.is_ended);
    EXPECT_FALSE(prove_lightest(problem, 1.0002 * best_kg, effort).holds) << root;
    EXPECT_FALSE(prove_lightest(problem, kInfinity, effort).holds) << root;
  }
  EXPECT_GE(with_designs, is_long ? 5 : 1);
}

TEST(SizedProof, GoesThroughAllWholeNumbers) {
  for (const TrainParts& parts : all_train_parts()) {
    json root = parts.name == "planetary" ? test::small_stage()
                : parts.name == "3k"      ? test::small_synthesis()
                                          : test::small_stepped(parts.name);
    root["ratio_tolerance"] = 0.02;
    root["planet_count"] = {3, 4, 5, 6};
    for (const bool has_second_module : {false, true}) {
      if (has_second_module && parts.layer_count() < 2) continue;
      if (has_second_module) root["synthesis"]["layer_2_module_mm"] = {0.5, 0.6, 0.8};
      root["max_backlash_rad_per_mm"] = 0.25;
      std::int64_t count = 0;
      for_each_choice(test::problem_from(root), [&](const WholeNumbers&) {
        ++count;
        return true;
      });
      EXPECT_EQ(count, oracles::count_loaded_choices(root)) << parts.name;
      EXPECT_GT(count, 5) << parts.name;
    }
  }
}

TEST(SizedProof, OfNoDesignHoldsWhereFloorsLeaveNone) {
  ProofEffort effort;
  json root = proved_examples().front();
  EXPECT_FALSE(prove_lightest(test::problem_from(root), kInfinity, effort).holds);
  for (const json& floor :
       {json{{"max_axial_length_mm", 5}}, json{{"min_backward_efficiency", 0.99}},
        json{{"min_hollow_shaft_diameter_mm", 40}}, json{{"max_reflected_inertia_kg_m2", 0.0001}},
        json{{"max_mass_kg", 0.1}}}) {
    EXPECT_TRUE(prove_lightest(test::problem_from(with(root, floor)), kInfinity, effort).holds)
        << floor;
  }
}

TEST(SizedProof, EndsWhenToldTo) {
  const Problem problem = test::problem_from(proved_examples().front());
  ProofEffort few{.most_boxes = 10};
  EXPECT_FALSE(prove_lightest(problem, 0.2, few).holds);
  EXPECT_TRUE(few.is_ended);
  ProofEffort none{.should_stop = [] { return true; }};
  EXPECT_FALSE(prove_lightest(problem, 0.2, none).holds);
  EXPECT_TRUE(none.is_ended);
}

}  // namespace
}  // namespace torquewright::gearbox::sized
