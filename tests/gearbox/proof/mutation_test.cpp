// SPDX-License-Identifier: Apache-2.0
// Every field that a proof rests on is changed in every way, in results made without the search.
// The checker has to refuse, but for the changes below. tests/gearbox/verification does the same to
// every field of results of the search.
#include "tests/gearbox/proof/mutation.hpp"

#include <gtest/gtest.h>

#include <regex>

#include "gearbox/proof/result/certificate.hpp"
#include "tests/gearbox/proof/another_proof.hpp"
#include "tests/gearbox/proof/naive_result.hpp"
#include "tests/long_run.hpp"

namespace torquewright::gearbox::proof_test {
namespace {

/// A change that leaves the result true: where, which, and why.
struct Harmless {
  std::regex pointer;
  std::regex kind;
  const char* reason;
};

const std::vector<Harmless>& harmless() {
  static const std::vector<Harmless> list = {
      {std::regex("/(kind|version)"), std::regex(".*"), "the reader of documents judges the head"},
      {std::regex("|/(designs|ties|conflict|would_be_feasible_with).*"), std::regex("add key"),
       "descriptive: compared with a fresh evaluation elsewhere"},
      {std::regex("/(conflict|would_be_feasible_with)/[0-9]+/(sentence|unit)"), std::regex(".*"),
       "descriptive: compared with a fresh evaluation elsewhere"},
      {std::regex("/conflict/[0-9]+"), std::regex("swap with next"), "a conflict is a set"},
      {std::regex("/certificate/claims/[0-9]+/constraints/[0-9]+"), std::regex("swap with next"),
       "hypotheses are a set"},
      {std::regex("/certificate/claims/[0-9]+/alternatives/[0-9]+"), std::regex("swap with next"),
       "alternatives say themselves which they are"},
      {std::regex("/(objective|bound|gap)|/certificate/claims/[0-9]+/"
                  "(quantity|reference|key|ring_limit)"),
       std::regex("remove key"), "absent is null; reached where the value was null"},
      {std::regex("/(ties|designs|conflict|would_be_feasible_with)"), std::regex("remove key"),
       "absent is empty; reached where the list was empty"},
  };
  return list;
}

bool is_harmless(const Mutation& mutation, const Json& before) {
  const Json::json_pointer pointer(mutation.pointer);
  for (const Harmless& each : harmless()) {
    if (!std::regex_match(mutation.pointer, each.pointer)) continue;
    if (!std::regex_match(mutation.kind, each.kind)) continue;
    const std::string reason = each.reason;
    if (reason.rfind("absent", 0) == 0 && !before[pointer].empty()) continue;
    return true;
  }
  return false;
}

std::vector<std::string> words(const Problem& problem) {
  std::vector<std::string> all = constraint_names(problem);
  for (const char* word : {"optimal",
                           "infeasible",
                           "limit",
                           "optimum",
                           "least_relaxation",
                           "ratio_max",
                           "ratio_min",
                           "quantity",
                           "positive_teeth",
                           "paper_cost",
                           "mass",
                           "hollow_shaft",
                           "forward_efficiency",
                           "reflected_inertia",
                           "carrier_clearance",
                           "ring_pitch_diameter_mm",
                           "ratio_error",
                           "teeth.sun",
                           "/min_teeth/sun",
                           "/min_carrier_clearance_rad",
                           "/rotor_inner_diameter_mm",
                           "/ratio_tolerance",
                           "/min_contact_ratio",
                           "/ring_outer_diameter_mm",
                           "sun"}) {
    all.push_back(word);
  }
  return all;
}

/// One in so many changes of nodes is made, which are alike by the hundred: with a stride of 3 the
/// five ways to change a number are each taken in turn.
int stride_in_tree() { return test::is_long_run() ? 1 : 3; }

/// The changes that make other proofs are a tenth at most, or the oracle excuses too much.
void expect_refusals(const Problem& problem, Json result) {
  ASSERT_TRUE(proof::check_certificate(problem, result).accepted);
  const Json before = result;
  int changes = 0, refused = 0, other_proofs = 0, unexcused = 0, in_tree = 0;
  for_each_mutation(result, words(problem), [&](const Mutation& mutation) {
    const bool is_of_tree = mutation.pointer.find("/nodes/") != std::string::npos;
    if (is_of_tree && in_tree++ % stride_in_tree() != 0) return;
    ++changes;
    if (!proof::check_certificate(problem, result).accepted) {
      ++refused;
    } else if (is_harmless(mutation, before)) {
      return;
    } else if (is_another_proof(problem, result, mutation.pointer)) {
      ++other_proofs;
    } else if (++unexcused < 20) {
      ADD_FAILURE() << mutation.pointer << ": " << mutation.kind;
    }
  });
  EXPECT_EQ(unexcused, 0);
  EXPECT_LE(10 * other_proofs, changes);
  testing::Test::RecordProperty("changes", changes);
  testing::Test::RecordProperty("refused", refused);
  testing::Test::RecordProperty("other_proofs", other_proofs);
}

TEST(Mutation, OfTheD151) { expect_refusals(d151(), naive_optimum(d151(), 1, {})); }

TEST(Mutation, OfAToleranceWithTwoDesigns) {
  expect_refusals(d151_tolerant(), naive_optimum(d151_tolerant(), 2, {}));
}

TEST(Mutation, OfRelaxationLeaves) {
  expect_refusals(d151_tolerant(), naive_optimum(d151_tolerant(), 1, {256, true, true}));
}

TEST(Mutation, OfAPlanetary) {
  expect_refusals(planetary_8(), naive_optimum(planetary_8(), 2, {}));
}

TEST(Mutation, OfAnEfficiency) {
  expect_refusals(most_efficient(), naive_optimum(most_efficient(), 2, {4096, true, false}));
}

TEST(Mutation, OfALimit) {
  expect_refusals(d151_tolerant(), naive_limit(d151_tolerant(), 0.875, {}));
}

TEST(Mutation, OfAConflict) {
  expect_refusals(d151_infeasible(),
                  naive_infeasible(d151_infeasible(),
                                   {"/min_carrier_clearance_rad", "/rotor_inner_diameter_mm"},
                                   {1024, true, false}));
}

}  // namespace
}  // namespace torquewright::gearbox::proof_test
