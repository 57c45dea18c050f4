// SPDX-License-Identifier: Apache-2.0
// Results of a synthesis, honest and forged. Oracle of what is a lie: the honest result itself, of
// which each forgery says more than is so.
#include <gtest/gtest.h>

#include <functional>

#include "gearbox/any_topology.hpp"
#include "gearbox/problem_spec.hpp"
#include "gearbox/synthesis/floor_conflict.hpp"
#include "gearbox/synthesis/synthesis_spec.hpp"
#include "gearbox/synthesis_defaults_spec.hpp"
#include "gearbox/verification/verification_json.hpp"
#include "io/documents/document.hpp"
#include "io/documents/provenance.hpp"
#include "tests/gearbox/synthesis/synthesis_example.hpp"
#include "tests/gearbox/verification/real_result.hpp"

namespace torquewright::gearbox::verification_test {
namespace {

/// One choice of teeth.
Json one_choice(const Json& changes = Json::object()) {
  Json problem = gearbox::test::small_synthesis();
  problem["planet_count"] = 3;
  problem["min_teeth"] = {{"sun", 50}, {"planet_1", 20}, {"planet_2", 16}};
  problem["synthesis"]["gap"] = 0.005;
  problem.merge_patch(changes);
  return problem;
}

/// What `gearbox optimize` writes.
Json sized_result(const Json& problem, std::int64_t max_boxes = 0) {
  const io::Document document = io::check_document(problem, "gearbox_problem", "p.json", "");
  const Problem read = read_open_problem(document);
  SynthesisOptions options;
  options.max_boxes = max_boxes;
  SynthesisResult found = synthesise(read, options);
  if (found.status == SynthesisStatus::kInfeasible) explain_conflict(read, {}, found);
  nlohmann::ordered_json result = synthesis_json(read, found);
  result["problem"] = document.root;
  if (is_topology_open(read) && found.best) {
    result["certificate"]["asked"] = document.root;
    result["problem"] = as_topology(document.root, train_parts(found.best->problem.topology));
  }
  result["tool"] = io::tool_provenance();
  result["inputs"] = io::input_provenance({&document, 1});
  return Json::parse(result.dump());
}

Verification sized_verified(const Json& result) {
  try {
    const io::Document document = io::check_document(result, "gearbox_result", "result", "");
    const io::Document problem =
        io::check_document(result["problem"], "gearbox_problem", "result", "/problem");
    return verify(read_open_problem(problem), document.root);
  } catch (const io::SpecError& error) {
    Verification refused;
    refused.faults = {error.what()};
    return refused;
  }
}

const Json& honest() {
  static const Json result = sized_result(one_choice());
  return result;
}

TEST(SizedVerification, SaysWhatIsProved) {
  const Verification found = sized_verified(honest());
  ASSERT_TRUE(found.is_accepted) << found.faults.front();
  EXPECT_TRUE(found.is_proved);
  EXPECT_EQ(found.choices, 1);
  EXPECT_GT(found.counts.nodes, 100);
  EXPECT_TRUE(found.claim.starts_with("51/25/20/102/96 with 3 planets, module 0.7 mm satisfies "))
      << found.claim;
}

struct Forgery {
  const char* what;
  std::function<void(Json&)> forge;
  const char* fault;  ///< Where it is found.
};

void set_bound(Json& result, double bound) {
  result["bound"] = bound;
  result["gap"] = 1.0 - bound / result["objective"].get<double>();
  result["certificate"]["sized_claims"][0]["bound"] = bound;
}

TEST(SizedVerification, RefusesForgeries) {
  const double kg = honest()["objective"];
  const std::vector<Forgery> forgeries{
      {"a bound above the design", [&](Json& r) { set_bound(r, 1.001 * kg); }, "/"},
      // The search's design is not the very lightest: there is room between it and the optimum.
      {"a bound of another problem",
       [&](Json& r) {
         r["problem"]["min_teeth"]["sun"] = 40;
         r["problem"]["module_mm"] = {0.6, 0.7};
         set_bound(r, 0.9999 * kg);
       },
       "/certificate/sized_claims/0/"},
      {"a bound without its claim",
       [](Json& r) { r["certificate"]["sized_claims"] = Json::array(); },
       "/certificate/sized_claims: "},
      {"a claim of less than the bound",
       [](Json& r) {
         r["certificate"]["sized_claims"][0]["bound"] = 0.5 * r["bound"].get<double>();
       },
       "/bound: is above that of the topology 3k"},
      {"a claim twice",
       [](Json& r) {
         r["certificate"]["sized_claims"].push_back(r["certificate"]["sized_claims"][0]);
       },
       "/certificate/sized_claims: "},
      {"another topology's claim",
       [](Json& r) { r["certificate"]["sized_claims"][0]["topology"] = "3k_b"; },
       "/certificate/sized_claims/0/topology"},
      {"more choices than there are",
       [](Json& r) { r["certificate"]["sized_claims"][0]["choices"] = 2; },
       "/certificate/sized_claims/0/choices: is not 1"},
      {"no design, where there is one",
       [](Json& r) {
         r["status"] = "infeasible";
         r["designs"] = Json::array();
         r["objective"] = r["bound"] = r["gap"] = nullptr;
         r["certificate"]["sized_claims"][0]["bound"] = nullptr;
         r["certificate"]["sized_claims"][0]["left_out"] = Json::array();
       },
       "/certificate/sized_claims/0/bound: is not proved"},
      {"a tooth more", [](Json& r) { r["designs"][0]["teeth"]["planet_2"] = 21; }, "/designs/0"},
      {"a shift",
       [](Json& r) {
         Json& shift = r["designs"][0]["profile_shift"]["planet_1"];
         shift = shift.get<double>() + 0.01;
       },
       "/designs/0"},
      {"a narrower tooth",
       [](Json& r) {
         Json& width = r["designs"][0]["face_width_mm"]["layer_1"];
         width = 0.99 * width.get<double>();
       },
       "/designs/0: bears "},
      {"a wider tooth",
       [](Json& r) {
         Json& width = r["designs"][0]["face_width_mm"]["layer_2"];
         width = 1.01 * width.get<double>();
       },
       "/designs/0/face_width_mm/layer_2"},
      {"a lighter design", [](Json& r) { r["objective"] = 0.9995 * r["objective"].get<double>(); },
       "/"},
      {"more load borne", [](Json& r) { r["designs"][0]["strength"]["borne_Nm"] = 130; },
       "/designs/0/strength/borne_Nm"},
      {"a lighter load", [](Json& r) { r["problem"]["load"]["output_torque_Nm"] = 60; }, "/"},
      {"a heavier load", [](Json& r) { r["problem"]["load"]["output_torque_Nm"] = 121; },
       "/designs/0: bears "},
      {"a floor that the design does not meet",
       [](Json& r) { r["problem"]["min_hollow_shaft_diameter_mm"] = 33; },
       "/designs/0: violates hollow_shaft"},
      {"optimal for limit", [](Json& r) { r["status"] = "limit"; }, "/status"},
      {"another gap", [](Json& r) { r["problem"]["synthesis"]["gap"] = 0.00001; }, "/status"},
      {"a planet count that is not offered", [](Json& r) { r["problem"]["planet_count"] = 4; },
       "/designs/0/planet_count"}};
  for (const Forgery& each : forgeries) {
    Json result = honest();
    each.forge(result);
    const Verification found = sized_verified(result);
    EXPECT_FALSE(found.is_accepted) << each.what;
    ASSERT_FALSE(found.faults.empty()) << each.what;
    EXPECT_EQ(found.faults.front().find(each.fault), 0U)
        << each.what << ": " << found.faults.front();
  }
}

// Less than was found is true as well: of the bound, as long as it is said with its gap.
TEST(SizedVerification, AcceptsAWeakerBound) {
  Json result = honest();
  set_bound(result, 0.997 * result["objective"].get<double>());
  EXPECT_TRUE(sized_verified(result).is_accepted);
}

TEST(SizedVerification, IsUndecidedAboutALimit) {
  const Json result = sized_result(one_choice(), 60);
  ASSERT_EQ(result["status"], "limit");
  const Verification found = sized_verified(result);
  EXPECT_TRUE(found.is_accepted) << found.faults.front();
  EXPECT_TRUE(found.is_undecided);
}

TEST(SizedVerification, KnowsConflictsAndOpenTopologies) {
  const Json conflict = sized_result(
      one_choice({{"min_backward_efficiency", 0.99}, {"min_hollow_shaft_diameter_mm", 1}}));
  ASSERT_EQ(conflict["status"], "infeasible");
  ASSERT_EQ(conflict["conflict"].size(), 1U);
  Verification found = sized_verified(conflict);
  EXPECT_TRUE(found.is_accepted) << found.faults.front();
  Json forged = conflict;
  forged["conflict"][0]["constraint"] = "hollow_shaft";
  EXPECT_FALSE(sized_verified(forged).is_accepted);
  forged = conflict;
  forged["conflict"][0]["without_it"]["profile_shift"]["sun"] = 0.9;
  EXPECT_FALSE(sized_verified(forged).is_accepted);
  forged = conflict;
  forged["certificate"]["sized_claims"][0]["left_out"].push_back("backward_efficiency");
  EXPECT_FALSE(sized_verified(forged).is_accepted);

  const Json open = sized_result(gearbox::test::small_open_problem());
  ASSERT_EQ(open["status"], "optimal");
  found = sized_verified(open);
  EXPECT_TRUE(found.is_accepted) << found.faults.front();
  forged = open;
  forged["certificate"]["sized_claims"].erase(0);
  EXPECT_FALSE(sized_verified(forged).is_accepted);
  forged = open;
  forged["certificate"].erase("asked");  // Then it is about one topology.
  EXPECT_FALSE(sized_verified(forged).is_accepted);
  forged = open;
  forged["topologies"][0]["bound"] = 2.0 * open["topologies"][0]["bound"].get<double>();
  EXPECT_FALSE(sized_verified(forged).is_accepted);
}

}  // namespace
}  // namespace torquewright::gearbox::verification_test
