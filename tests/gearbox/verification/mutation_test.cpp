// SPDX-License-Identifier: Apache-2.0
// Every field of results of the search is changed: in every way in one of them, by a sample of the
// ways in the others; proof trees by a sample of all changes. What `verify` then accepts has to be
// one of the exceptions that docs/certificate.md lists, or another proof of the same claim, by the
// oracle that tries all teeth.
#include "tests/gearbox/proof/mutation.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <map>

#include "tests/gearbox/proof/another_proof.hpp"
#include "tests/gearbox/verification/exceptions.hpp"
#include "tests/gearbox/verification/real_result.hpp"
#include "tests/long_run.hpp"

namespace torquewright::gearbox::verification_test {
namespace {

using proof_test::Mutation;

/// Every other change of what long studies make.
const std::size_t kFewer = test::is_long_run() ? 1 : 2;

struct Case {
  const char* name;
  Json problem;
  Json options;
  std::size_t stride;          ///< One in so many changes of each field is made, ...
  std::size_t stride_in_tree;  ///< ... and of all changes within proof trees.
};

const Json kSmall = {{"rotor_inner_diameter_mm", 60},
                     {"min_carrier_clearance_rad", 0.1},
                     {"ratio_tolerance", 0.01},
                     {"min_teeth", {{"sun", 20}, {"planet_1", 20}, {"planet_2", 16}}}};

Json small_with(const Json& changes) {
  Json all = kSmall;
  all.merge_patch(changes);
  return knee_with(all);
}

std::vector<Case> cases() {
  const Json shaft = {{"objective", "hollow_shaft"},
                      {"constraints", "buildable"},
                      {"rotor_inner_diameter_mm", 79.4},
                      {"face_width_mm", {{"layer_1", 10}, {"layer_2", 12}}},
                      {"materials", {{"density_kg_m3", 7850}}},
                      {"rotor_inertia_kg_m2", 9.5e-4}};
  const Json relaxed = {{"ratio_tolerance", 0.05},
                        {"min_teeth", {{"sun", 12}, {"planet_1", 12}, {"planet_2", 10}}}};
  return {
      {"paper", knee_with(), Json::object(), 1, 13},
      {"paper, fewer designs than asked for", knee_with(), {{"top", 5}}, 4, 29},
      {"paper, relaxations", small_with(relaxed), {{"relaxation", "always"}, {"top", 2}}, 7, 37},
      {"buildable", small_with(shaft), {{"relaxation", "never"}}, 5, 37},
      {"planetary, ties",
       problem_with("d110a_ankle", {{"ratio_tolerance", 0.05}, {"ring_outer_diameter_mm", 95}}),
       {{"top", 4}},
       13,
       13},
      {"efficiency", small_with({{"objective", "forward_efficiency"}}), {{"top", 2}}, 5, 53},
      {"infeasible", knee_with({{"min_carrier_clearance_rad", 0.3}}), {{"top", 2}}, 5, 101},
      {"limit",
       small_with({{"objective", "backward_efficiency"}}),
       {{"max_nodes", 20}, {"time_limit_s", 1000}},
       5,
       53},
      {"limit without a design", small_with(Json::object()), {{"max_nodes", 1}}, 5, 3},
  };
}

const std::vector<std::string>& words() {
  static const std::vector<std::string> all = {
      "",         "optimal",   "infeasible", "limit",      "optimum",   "paper_cost",
      "quantity", "ratio_max", "ratio",      "rotor_bore", "sun",       "planetary",
      "always",   "never",     "layer_2",    "mm",         "teeth.sun", "buildable"};
  return all;
}

struct Tally {
  int changes = 0;
  int other_proofs = 0;
  int unexcused = 0;
  std::map<std::string, int> exercised;  ///< By the exception's field.
};

/// Which changes are made: of the f-th field the j-th where f + j is a multiple of the stride.
class Sample {
 public:
  explicit Sample(const Case& of) : case_(of) {}

  bool takes(const Mutation& mutation) {
    if (mutation.pointer.find("/nodes/") != std::string::npos) {
      return in_tree_++ % (kFewer * case_.stride_in_tree) == 0;
    }
    const auto [field, is_new] = fields_.emplace(mutation.pointer, fields_.size());
    return field->second++ % (kFewer * case_.stride) == 0;
  }

 private:
  const Case& case_;
  std::size_t in_tree_ = 0;
  std::map<std::string, std::size_t> fields_;  ///< Number of the next change, from f on.
};

void try_all(const Case& each, Tally& tally) {
  const test::ScratchFolder folder;
  Json result = real_result(folder, each.problem, each.options);
  result["search"]["seconds"] = 0.25;
  const Json before = result;
  const Verification found = verified(result);
  ASSERT_TRUE(found.is_accepted) << each.name << ": " << found.faults.front();
  ASSERT_TRUE(found.unchecked.empty()) << found.unchecked.front();
  Sample sample(each);
  proof_test::for_each_mutation(result, words(), [&](const Mutation& mutation) {
    const Exception* exception = find_exception(mutation, before);
    if (!sample.takes(mutation) && exception == nullptr) return;
    ++tally.changes;
    if (!verified(result).is_accepted) return;
    if (exception != nullptr) {
      ++tally.exercised[exception->field];
    } else if (proof_test::is_another_proof(problem_of(before), result, mutation.pointer)) {
      ++tally.other_proofs;
    } else if (++tally.unexcused < 30) {
      ADD_FAILURE() << each.name << ": " << mutation.pointer << ": " << mutation.kind;
    }
  });
}

TEST(Mutation, OfAnyFieldIsRefusedOrListed) {
  Tally tally;
  for (const Case& each : cases()) try_all(each, tally);
  EXPECT_EQ(tally.unexcused, 0);
  EXPECT_GT(tally.changes, 7000 / static_cast<int>(kFewer));
  EXPECT_GT(tally.other_proofs, 0);
  EXPECT_LE(20 * tally.other_proofs, tally.changes);
  for (const Exception& each : exceptions()) {
    EXPECT_GT(tally.exercised[each.field], 0) << each.field << ": no change needs this exception";
  }
  RecordProperty("changes", tally.changes);
  RecordProperty("other_proofs", tally.other_proofs);
}

// The section's table has a row for every exception, and one for other proofs.
TEST(Mutation, ExceptionsAreThoseOfTheDocumentation) {
  std::ifstream file(TORQUEWRIGHT_SOURCE_DIR "/docs/certificate.md");
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  const std::size_t start = text.find("## What may be changed");
  ASSERT_NE(start, std::string::npos);
  const std::string section = text.substr(start, text.find("\n## ", start + 1) - start);
  for (const Exception& each : exceptions()) {
    const std::string row = "| " + each.field + " | " + each.reason + " |";
    EXPECT_NE(section.find(row), std::string::npos) << row;
  }
  std::size_t rows = 0;
  for (std::size_t i = 1; i < section.size(); ++i)
    rows += section[i] == '|' && section[i - 1] == '\n';
  EXPECT_EQ(rows, 2 + exceptions().size() + 1);
}

}  // namespace
}  // namespace torquewright::gearbox::verification_test
