// SPDX-License-Identifier: Apache-2.0
// Constraints of gearboxes: those that designs are judged by, those the search keeps, those that
// the checker of proofs knows and those of docs/gearbox_constraints.md are the same. Oracle: the
// files, and the names on that page.
#include <gtest/gtest.h>

#include "gearbox/proof/claims/constraint.hpp"
#include "gearbox/topologies/topology.hpp"
#include "tests/gates/excuses.hpp"
#include "tests/gates/source_tree.hpp"
#include "tests/gearbox/example_problem.hpp"

namespace torquewright::gates {
namespace {

namespace fs = std::filesystem;
using gearbox::Rational;

/// A problem in which no constraint is left out, whatever it is that makes it apply.
gearbox::Problem with_every_constraint(const gearbox::Topology& topology) {
  gearbox::Problem problem = gearbox::test::knee();
  problem.topology = topology.name;
  problem.constraints = gearbox::ConstraintSet::kBuildable;
  problem.objective = gearbox::Objective::kHollowShaft;  // Of either topology; any would do.
  problem.ring_outer_diameter_mm = Rational(90);
  // Of what is not stated of the cutters nobody asks.
  problem.cutters = {Rational(3, 10), Rational(1, 5), 20, Rational(5, 4), Rational(5, 4)};
  problem.min_teeth.clear();
  for (std::size_t i = 0; i < topology.free_gears; ++i) {
    problem.min_teeth[std::string(topology.gears[i])] = 20;
  }
  return problem;
}

gearbox::Design some_design(const gearbox::Topology& topology, const gearbox::Problem& problem) {
  std::vector<std::int64_t> free_teeth{44, 44, 32};
  free_teeth.resize(topology.free_gears);
  return {topology.complete(free_teeth), problem.planet_count.front(), problem.module_mm.front()};
}

Names judged_by(const gearbox::Topology& topology) {
  const gearbox::Problem problem = with_every_constraint(topology);
  Names names;
  for (const auto& report :
       topology.evaluate(problem, some_design(topology, problem)).constraints) {
    names.insert(report.name);
  }
  return names;
}

Names searched_with(const gearbox::Topology& topology) {
  const gearbox::Problem problem = with_every_constraint(topology);
  const optimization::Problem model =
      topology.model(problem, problem.planet_count.front(), problem.module_mm.front(), 132);
  Names names;
  for (const auto& condition : model.conditions) names.insert(condition.constraint);
  for (const auto& predicate : model.predicates) names.insert(predicate.constraint);
  return names;
}

/// The checker's own writing of the list, which shares nothing with the other two.
Names checked_by_proofs(const gearbox::Topology& topology) {
  Names names;
  for (const auto& constraint : gearbox::proof::constraints_of(with_every_constraint(topology))) {
    names.insert(constraint.name);
  }
  return names;
}

class EveryTopology : public testing::TestWithParam<gearbox::Topology> {};
/// Without shifts; what only synthesis searches has neither model nor claims.
class EverySearchedTopology : public EveryTopology {};

std::vector<gearbox::Topology> searched_topologies() {
  std::vector<gearbox::Topology> list;
  for (const gearbox::Topology& topology : gearbox::topologies()) {
    if (!topology.needs_synthesis) list.push_back(topology);
  }
  return list;
}

/// Names with "STEM.*" in place of those that it stands for.
Names by_pattern(const Names& names, const Names& patterns) {
  Names result;
  for (const std::string& name : names) {
    std::string own = name;
    for (const std::string& pattern : patterns) {
      const std::string stem = pattern.substr(0, pattern.size() - 1);
      if (pattern.ends_with(".*") && name.starts_with(stem)) own = pattern;
    }
    result.insert(own);
  }
  return result;
}

TEST_P(EveryTopology, IsJudgedByTheConstraintsOfItsPage) {
  const std::string page = text_of("docs/gearbox_constraints.md");
  const std::string own = section(page, "## " + std::string(GetParam().name));
  Names documented = named_in_first_column(own);
  if (documented.empty()) {  // A topology that repeats another's is listed in a sentence.
    documented = matches(own, "`([^`]+)`");
    documented.erase("buildable");
    documented.erase("synthesis");
  }
  EXPECT_EQ(by_pattern(judged_by(GetParam()), documented), documented);
}

TEST_P(EverySearchedTopology, IsCheckedByTheConstraintsThatItIsJudgedBy) {
  EXPECT_EQ(checked_by_proofs(GetParam()), judged_by(GetParam()));
}

TEST_P(EverySearchedTopology, IsSearchedWithAllConstraintsThatItIsJudgedBy) {
  Names searched = searched_with(GetParam());
  searched.erase("positive_teeth");  // A train with no tooth on planet 2 is no design.
  EXPECT_EQ(searched, judged_by(GetParam()));
}

INSTANTIATE_TEST_SUITE_P(Topologies, EveryTopology,
                         testing::ValuesIn(gearbox::topologies().begin(),
                                           gearbox::topologies().end()),
                         [](const auto& test) { return "of_" + std::string(test.param.name); });

INSTANTIATE_TEST_SUITE_P(Topologies, EverySearchedTopology,
                         testing::ValuesIn(searched_topologies()),
                         [](const auto& test) { return "of_" + std::string(test.param.name); });

TEST(EveryConstraint, IsPutToUseByATopology) {
  std::string used;
  for (const fs::path& file : files_in("gearbox/topologies", ".cpp")) used += text_of(file);
  used += text_of("gearbox/constraints/buildable.cpp");
  for (const fs::path& file : files_in("gearbox/constraints", ".hpp")) {
    if (file.stem() == "condition") continue;  // How each of them is judged.
    for (const std::string& name : matches(text_of(file), R"(^ConstraintReport (\w+)\()")) {
      EXPECT_NE(used.find(name + "("), std::string::npos) << file << " " << name;
    }
  }
}

}  // namespace
}  // namespace torquewright::gates
