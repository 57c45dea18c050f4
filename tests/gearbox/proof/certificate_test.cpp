// SPDX-License-Identifier: Apache-2.0
#include "gearbox/proof/result/certificate.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/gearbox/proof/naive_result.hpp"

namespace torquewright::gearbox::proof_test {
namespace {

using proof::check_certificate;
using proof::Verdict;

std::string listed(const Verdict& verdict) {
  return fmt::format("{}", fmt::join(verdict.faults, "\n"));
}

void expect_accepted(const Problem& problem, const Json& result) {
  const Verdict verdict = check_certificate(problem, result);
  EXPECT_TRUE(verdict.accepted) << listed(verdict);
  EXPECT_FALSE(verdict.undecided);
  EXPECT_GT(verdict.counts.nodes, 0);
}

// Oracle: the published optimum; reference/minlp.md section 7.
TEST(Certificate, AcceptsTheD151) {
  const Json result = naive_optimum(d151(), 1, {});
  EXPECT_EQ(result["designs"][0]["teeth"]["planet_2"], 32);
  EXPECT_NEAR(result["objective"].get<double>(), 17360.1116, 1e-4);
  expect_accepted(d151(), result);
}

TEST(Certificate, AcceptsThatThereIsNoSecondDesign) {
  const Json result = naive_optimum(d151(), 5, {});
  EXPECT_TRUE(result["certificate"]["claims"][0]["reference"].is_null());
  expect_accepted(d151(), result);
}

TEST(Certificate, AcceptsTheFourBestWithinATolerance) {
  const Json result = naive_optimum(d151_tolerant(), 4, {});
  EXPECT_EQ(result["designs"].size(), 4U);
  expect_accepted(d151_tolerant(), result);
}

TEST(Certificate, AcceptsLargeEnumeratedLeavesAndNoCuts) {
  expect_accepted(d151(), naive_optimum(d151(), 1, {4096, false, false}));
}

TEST(Certificate, AcceptsRelaxationLeaves) {
  const Problem problem = d151_tolerant();
  const Json result = naive_optimum(problem, 1, {16, false, true});
  const Verdict verdict = check_certificate(problem, result);
  EXPECT_TRUE(verdict.accepted) << listed(verdict);
  EXPECT_GT(verdict.counts.relaxation_leaves, 3);
}

TEST(Certificate, AcceptsAPlanetaryOfLeastMassAmongPlanetsAndModules) {
  expect_accepted(planetary_8(), naive_optimum(planetary_8(), 2, {}));
}

TEST(Certificate, AcceptsTheMostEfficient) {
  expect_accepted(most_efficient(), naive_optimum(most_efficient(), 3, {}));
}

TEST(Certificate, AcceptsTheLeastInertiaThatCanBeBuilt) {
  expect_accepted(buildable_inertia(), naive_optimum(buildable_inertia(), 2, {}));
}

TEST(Certificate, AcceptsAConflictWithItsLeastRelaxations) {
  const std::vector<std::string> keys{"/min_carrier_clearance_rad", "/ratio_tolerance",
                                      "/rotor_inner_diameter_mm"};
  const Json result = naive_infeasible(d151_infeasible(), keys, {});
  EXPECT_EQ(result["would_be_feasible_with"].size(), 3U);
  expect_accepted(d151_infeasible(), result);
}

}  // namespace
}  // namespace torquewright::gearbox::proof_test
