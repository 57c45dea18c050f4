// SPDX-License-Identifier: Apache-2.0
// `gearbox pareto`. Oracles: for whole numbers, the list of all designs that `gearbox optimize
// --top` gives, thinned to those that none dominates; with synthesis, `gearbox optimize` of the
// problem with the floor that a point states.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "io/documents/schema.hpp"
#include "tests/cli/workplace.hpp"

namespace torquewright::cli_test {
namespace {

using nlohmann::json;

json whole_problem() {
  json problem = json::parse(knee());
  problem["ratio_tolerance"] = 0.02;
  problem["planet_count"] = {3, 4};
  problem["min_teeth"] = {{"sun", 24}, {"planet_1", 24}, {"planet_2", 18}};
  problem["min_carrier_clearance_rad"] = 0;
  return problem;
}

TEST(Pareto, OfWholeNumbersIsEveryDesignThatNoneDominates) {
  const Workplace place;
  place.write("knee.json", whole_problem().dump());
  const Outcome front =
      place.run({"gearbox", "pareto", "knee.json", "--objectives", "paper_cost,forward_efficiency",
                 "--plot", "front.svg", "-o", "front.json"});
  ASSERT_EQ(front.exit_code, 0) << front.out << front.err;
  const json found = json::parse(place.text("front.json"));
  EXPECT_TRUE(io::conforms(found, "gearbox_front"));
  EXPECT_NE(place.text("front.svg").find("<circle"), std::string::npos);
  const Outcome all = place.run({"gearbox", "optimize", "knee.json", "--top", "100000", "--json"});
  const json designs = json::parse(all.out)["designs"];
  EXPECT_GT(designs.size(), 20U);
  std::vector<const json*> best;  // The list is sorted by cost.
  double most = 0.0;
  for (const json& design : designs) {
    if (design["forward_efficiency"].get<double>() <= most * (1.0 + 1e-9)) continue;
    most = design["forward_efficiency"];
    best.push_back(&design);
  }
  ASSERT_GT(best.size(), 2U);
  ASSERT_EQ(found["points"].size(), best.size());
  for (std::size_t i = 0; i < best.size(); ++i) {
    const json& point = found["points"][i];
    EXPECT_EQ(point["teeth"], (*best[i])["teeth"]);
    EXPECT_NEAR(point["first"].get<double>(), (*best[i])["objective"].get<double>(), 1e-9 * 1e5);
    EXPECT_EQ(point["from"], i == 0 ? json() : found["points"][i - 1]["second"]);
  }
}

/// A synthesis with few choices of teeth.
json few_choices() {
  return json::parse(R"({"kind": "gearbox_problem", "version": 1, "topology": "3k",
    "target_ratio": 20, "ratio_tolerance": 0, "rotor_inner_diameter_mm": 79.4, "module_mm": 0.7,
    "planet_count": 3, "min_teeth": {"sun": 50, "planet_1": 20, "planet_2": 16},
    "load": {"output_torque_Nm": 120, "cycles": 1000000}, "synthesis": {"gap": 0.01}})");
}

TEST(Pareto, OfASynthesisIsWhatOptimizeGivesForEachFloor) {
  const Workplace place;
  json problem = few_choices();
  place.write("gears.json", problem.dump());
  const Outcome front = place.run({"gearbox", "pareto", "gears.json", "--objectives",
                                   "mass,backward_efficiency", "--points", "3", "--json"});
  ASSERT_EQ(front.exit_code, 0) << front.out << front.err;
  const json found = json::parse(front.out);
  EXPECT_TRUE(io::conforms(found, "gearbox_front"));
  ASSERT_GE(found["points"].size(), 2U);
  double before_kg = 0.0;
  for (const json& point : found["points"]) {
    EXPECT_LE(point["bound"], point["first"]);
    EXPECT_GE(point["first"].get<double>(), before_kg);  // What is asked for more weighs more.
    before_kg = point["bound"];
  }
  const json& last = found["points"].back();
  problem["min_backward_efficiency"] = last["from"];
  place.write("gears.json", problem.dump());
  const Outcome alone = place.run({"gearbox", "optimize", "gears.json", "--json"});
  EXPECT_NEAR(json::parse(alone.out)["objective"].get<double>() / last["first"].get<double>(), 1.0,
              0.011);
  problem["min_backward_efficiency"] = found["none_from"];
  place.write("gears.json", problem.dump());
  EXPECT_EQ(place.run({"gearbox", "optimize", "gears.json"}).exit_code, 1);
}

// Less of the inertia weighs more. Oracle: `gearbox optimize` with that ceiling.
TEST(Pareto, OfASynthesisKnowsCeilings) {
  const Workplace place;
  json problem = few_choices();
  place.write("gears.json", problem.dump());
  const Outcome front = place.run({"gearbox", "pareto", "gears.json", "--objectives",
                                   "mass,reflected_inertia", "--points", "2", "--json"});
  ASSERT_EQ(front.exit_code, 0) << front.out << front.err;
  const json found = json::parse(front.out);
  for (const json& point : found["points"]) {
    if (point["from"].is_null()) continue;
    EXPECT_LE(point["second"], point["from"]);
  }
  for (std::size_t i = 1; i < found["points"].size(); ++i) {
    EXPECT_LT(found["points"][i]["second"], found["points"][i - 1]["second"]);
  }
  problem["max_reflected_inertia_kg_m2"] = found["none_from"];
  place.write("gears.json", problem.dump());
  EXPECT_EQ(place.run({"gearbox", "optimize", "gears.json"}).exit_code, 1);
}

TEST(Pareto, RefusesWhatItCannotTrade) {
  const Workplace place;
  place.write("knee.json", knee());
  const auto error = [&](const std::string& objectives) {
    const Outcome outcome =
        place.run({"gearbox", "pareto", "knee.json", "--objectives", objectives});
    EXPECT_EQ(outcome.exit_code, 2);
    return outcome.err;
  };
  EXPECT_NE(error("mass").find("takes two that differ"), std::string::npos);
  EXPECT_NE(error("mass,weight").find("\"weight\" is not an objective"), std::string::npos);
  EXPECT_NE(error("mass,paper_cost").find("can stand first only"), std::string::npos);
  place.write("tight.json", tight_knee());
  EXPECT_EQ(
      place
          .run({"gearbox", "pareto", "tight.json", "--objectives", "paper_cost,forward_efficiency"})
          .exit_code,
      1);
}

// Oracle: `gearbox optimize` of the same problem, topology by topology.
TEST(Pareto, OfAnOpenTopologyNamesThatOfEachPoint) {
  const Workplace place;
  json problem{{"kind", "gearbox_problem"}, {"version", 1}, {"topology", "any"}};
  problem["target_ratio"] = 14;
  problem["ratio_tolerance"] = 0;
  problem["rotor_inner_diameter_mm"] = 60;
  problem["module_mm"] = 0.5;
  problem["planet_count"] = 3;
  problem["min_teeth"] = {{"sun", 16}, {"planet_1", 24}, {"planet_2", 15}, {"planet", 16}};
  problem["load"] = {{"output_torque_Nm", 40}};
  problem["synthesis"] = {{"gap", 0.01}};
  place.write("open.json", problem.dump());
  const Outcome front =
      place.run({"gearbox", "pareto", "open.json", "--points", "1", "-o", "front.json"});
  ASSERT_EQ(front.exit_code, 0) << front.out << front.err;
  const json found = json::parse(place.text("front.json"));
  EXPECT_TRUE(io::conforms(found, "gearbox_front"));
  place.run({"gearbox", "optimize", "open.json", "-o", "best.json"});
  const json best = json::parse(place.text("best.json"));
  const json& point = found["points"].front();
  EXPECT_EQ(point["topology"], best["problem"]["topology"]);
  EXPECT_EQ(point["first"], best["objective"]);
  EXPECT_NE(front.out.find("  " + point["topology"].get<std::string>() + " "), std::string::npos)
      << front.out;
}

}  // namespace
}  // namespace torquewright::cli_test
