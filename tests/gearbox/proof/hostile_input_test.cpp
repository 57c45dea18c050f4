// SPDX-License-Identifier: Apache-2.0
// A result is a file of unknown origin: whatever stands in it, there is a verdict.
#include <gtest/gtest.h>

#include <limits>

#include "gearbox/proof/result/certificate.hpp"
#include "gearbox/proof/tree/refutation.hpp"
#include "tests/gearbox/proof/naive_result.hpp"

namespace torquewright::gearbox::proof_test {
namespace {

using proof::check_certificate;

std::vector<Json> strange_values() {
  Json deep = Json::array();
  for (int i = 0; i < 200; ++i) deep = Json::array({deep});
  return {Json(),
          Json(true),
          Json("x"),
          Json::array(),
          Json::object(),
          Json(-1),
          Json(std::numeric_limits<std::int64_t>::min()),
          Json(std::numeric_limits<std::int64_t>::max()),
          Json(std::numeric_limits<std::uint64_t>::max()),
          Json(1e308),
          Json(-1e308),
          Json(5e-324),
          Json(std::numeric_limits<double>::quiet_NaN()),
          Json(std::numeric_limits<double>::infinity()),
          Json("a/~b"),
          Json::array({1, 2}),
          Json::array({Json(), Json(), Json(), Json()}),
          Json{{"sun", "x"}},
          deep};
}

void collect(const Json& json, const Json::json_pointer& here,
             std::vector<Json::json_pointer>& pointers) {
  pointers.push_back(here);
  if (json.is_object()) {
    for (const auto& [key, value] : json.items()) collect(value, here / key, pointers);
  } else if (json.is_array()) {
    for (std::size_t i = 0; i < json.size(); ++i) collect(json[i], here / i, pointers);
  }
}

void put_strange_values_everywhere(const Problem& problem, const Json& result) {
  std::vector<Json::json_pointer> pointers;
  collect(result, Json::json_pointer(), pointers);
  for (const auto& pointer : pointers) {
    for (const Json& value : strange_values()) {
      Json changed = result;
      changed[pointer] = value;
      EXPECT_NO_THROW((void)check_certificate(problem, changed)) << pointer.to_string();
    }
  }
}

TEST(HostileInput, GivesAVerdictOnAnOptimum) {
  put_strange_values_everywhere(d151_tolerant(),
                                naive_optimum(d151_tolerant(), 1, {1024, true, true}));
}

TEST(HostileInput, GivesAVerdictOnAConflict) {
  put_strange_values_everywhere(
      d151_infeasible(),
      naive_infeasible(d151_infeasible(), {"/min_carrier_clearance_rad"}, {4096, true, false}));
}

TEST(HostileInput, RefusesWhatIsNoResult) {
  for (const Json& value : strange_values()) {
    EXPECT_FALSE(check_certificate(d151(), value).accepted) << value.dump();
  }
}

TEST(HostileInput, KeepsTheListOfFaultsShort) {
  Json result = naive_infeasible(d151_infeasible(), {}, {});
  for (int i = 0; i < 5000; ++i) result["certificate"]["claims"][0]["x" + std::to_string(i)] = 1;
  const auto verdict = check_certificate(d151_infeasible(), result);
  EXPECT_FALSE(verdict.accepted);
  EXPECT_EQ(verdict.faults.size(), 100U);
}

TEST(HostileInput, StopsAtTheFirstOfAMillionBadNodes) {
  Json result = naive_optimum(d151(), 1, {});
  Json& nodes = result["certificate"]["claims"][0]["alternatives"][0]["nodes"];
  nodes = Json(std::vector<int>(1000000, 7));
  const auto verdict = check_certificate(d151(), result);
  EXPECT_FALSE(verdict.accepted);
  EXPECT_EQ(verdict.counts.nodes, 1);
}

TEST(HostileInput, DoesNotJudgeRingsBeyondAMillionTeeth) {
  Problem problem = d151();
  Json result = naive_optimum(problem, 1, {});
  problem.rotor_inner_diameter_mm = Rational("1000000000000");
  EXPECT_FALSE(check_certificate(problem, result).accepted);
}

TEST(HostileInput, SpendsNoMoreThanItsBudget) {
  const Problem problem = most_efficient();
  proof::Claim claim;
  claim.kind = proof::ClaimKind::kOptimum;
  claim.hypotheses = proof::constraints_of(problem);
  claim.quantity = proof::objective_quantity(problem.objective);
  const proof::Alternative alternative(problem, 4, Rational(3, 5));
  claim.threshold = proof::value_at(*claim.quantity, alternative, {44, 44, 12});
  const proof::Box box{{20, 20, 1}, {60, 40, 20}};
  proof::Budget budget{100};
  const auto condition = proof::find_condition(claim, "quantity");
  EXPECT_FALSE(proof::refutes(claim, alternative, *condition, box, budget));
  EXPECT_TRUE(budget.is_exhausted());
}

}  // namespace
}  // namespace torquewright::gearbox::proof_test
