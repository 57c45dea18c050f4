// SPDX-License-Identifier: Apache-2.0
// Whenever a search is ended, what it hands over is true and proved as far as it goes. The oracle
// is the checker, which shares nothing with the search.
#include <gtest/gtest.h>

#include "gearbox/problem_spec.hpp"
#include "gearbox/proof/result/certificate.hpp"
#include "gearbox/search/result_spec.hpp"
#include "gearbox/search/search.hpp"
#include "io/documents/document.hpp"

namespace torquewright::gearbox {
namespace {

using nlohmann::json;

/// All objectives can be asked of it.
json problem_document(const std::string& topology, const std::string& objective) {
  const bool is_planetary = topology == "planetary";
  json document = {{"kind", "gearbox_problem"},
                   {"version", 1},
                   {"topology", topology},
                   {"target_ratio", is_planetary ? 8 : 20},
                   {"ratio_tolerance", 0.05},
                   {"rotor_inner_diameter_mm", 300},
                   {"module_mm", {0.5, 1}},
                   {"planet_count", {3, 4}},
                   {"min_teeth", {{"sun", 20}}},
                   {"min_carrier_clearance_rad", 0.1},
                   {"constraints", "buildable"},
                   {"objective", objective},
                   {"friction_coefficient", 0.08},
                   {"face_width_mm", {{"layer_1", 10}}},
                   {"materials", {{"density_kg_m3", 7800}}}};
  if (is_planetary) {
    document["min_teeth"]["planet"] = 20;
  } else {
    document["min_teeth"]["planet_1"] = document["min_teeth"]["planet_2"] = 20;
    document["face_width_mm"]["layer_2"] = 8;
  }
  return document;
}

Problem problem_of(const json& document) {
  return read_problem(io::check_document(document, "gearbox_problem", "test", ""));
}

proof::Verdict verdict_on(const Problem& problem, const DesignSearchResult& found) {
  return proof::check_certificate(problem, json::parse(result_json(problem, found).dump()));
}

struct Case {
  std::string topology, objective;
};

void PrintTo(const Case& each, std::ostream* stream) {
  *stream << each.topology << " " << each.objective;
}

class EndedSearch : public testing::TestWithParam<Case> {};

TEST_P(EndedSearch, HasAProvedBound) {
  const Problem problem = problem_of(problem_document(GetParam().topology, GetParam().objective));
  for (const std::int64_t nodes : {1, 2, 5, 20, 100, 400}) {
    DesignSearchOptions options;
    options.max_nodes = nodes;
    options.top = 2;
    const DesignSearchResult found = optimize(problem, options);
    const proof::Verdict verdict = verdict_on(problem, found);
    EXPECT_TRUE(verdict.accepted) << nodes << ": " << testing::PrintToString(verdict.faults);
    EXPECT_EQ(verdict.undecided, found.status == DesignSearchStatus::kLimit);
    EXPECT_TRUE(found.bound.has_value());
  }
}

INSTANTIATE_TEST_SUITE_P(
    Each, EndedSearch,
    testing::Values(Case{"3k", "paper_cost"}, Case{"3k", "hollow_shaft"}, Case{"3k", "mass"},
                    Case{"3k", "forward_efficiency"}, Case{"3k", "backward_efficiency"},
                    Case{"3k", "reflected_inertia"}, Case{"planetary", "hollow_shaft"},
                    Case{"planetary", "mass"}, Case{"planetary", "forward_efficiency"},
                    Case{"planetary", "backward_efficiency"},
                    Case{"planetary", "reflected_inertia"}));

// Told to stop at the first, second, third, ... time it asks, down to when it no longer asks.
TEST(EndedSearch, KeepsTheProofThatNoDesignExists) {
  json document = problem_document("3k", "paper_cost");
  document["target_ratio"] = 60;
  document["min_carrier_clearance_rad"] = 0.9;
  const Problem problem = problem_of(document);
  ASSERT_EQ(optimize(problem, {}).status, DesignSearchStatus::kInfeasible);
  bool is_ended = true;
  int infeasible = 0;
  for (int patience = 1; is_ended; patience += 1 + patience / 4) {
    int questions = 0;
    DesignSearchOptions options;
    options.should_stop = [&] { return ++questions >= patience; };
    const DesignSearchResult found = optimize(problem, options);
    is_ended = questions >= patience;
    const proof::Verdict verdict = verdict_on(problem, found);
    EXPECT_TRUE(verdict.accepted) << patience << ": " << testing::PrintToString(verdict.faults);
    infeasible += is_ended && found.status == DesignSearchStatus::kInfeasible ? 1 : 0;
  }
  EXPECT_GT(infeasible, 3);
}

}  // namespace
}  // namespace torquewright::gearbox
