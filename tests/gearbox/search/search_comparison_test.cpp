// SPDX-License-Identifier: Apache-2.0
// Oracle of all tests here: exhaustive enumeration (tests/oracles).
#include "tests/gearbox/search/search_comparison.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <cmath>

#include "gearbox/problem_spec.hpp"
#include "gearbox/topologies/topology.hpp"
#include "io/documents/document.hpp"
#include "tests/oracles/gearbox_enumeration.hpp"
#include "tests/oracles/involute_meshes.hpp"
#include "tests/oracles/named_problems.hpp"
#include "tests/oracles/problem_document.hpp"
#include "tests/oracles/random_problems.hpp"

namespace torquewright::search_test {
namespace {

using gearbox::Problem;
using optimization::RelaxationUse;

constexpr std::uint64_t kSeed = 151;
constexpr RelaxationUse kUses[] = {RelaxationUse::kAuto, RelaxationUse::kAlways,
                                   RelaxationUse::kNever};

void expect_agreement(const Problem& problem, RelaxationUse use, std::size_t top) {
  const Truth truth = enumerated(problem);
  ASSERT_FALSE(truth.is_doubtful) << problem.name;
  const Comparison comparison = compare(problem, truth, use, top);
  EXPECT_TRUE(comparison.disagreements.empty()) << fmt::format(
      "{}, relaxation {}, top {}: {}\n{}", problem.name, static_cast<int>(use), top,
      fmt::join(comparison.disagreements, "; "), oracles::problem_document(problem).dump());
}

Problem problem_in(const std::string& document) {
  return gearbox::read_problem(
      io::check_document(nlohmann::json::parse(document), "gearbox_problem", "problem.json", ""));
}

// The modes take turns; bench/random_problems has each of them solve each problem.
TEST(Search, AgreesWithEnumerationOnRandomProblems) {
  std::size_t index = 0;
  for (const Problem& problem : oracles::random_problems(kSeed, 100)) {
    expect_agreement(problem, kUses[index % 3], 1 + index % 5);
    ++index;
  }
}

// Of hobs and shapers of other addenda, and shapers that have to be fed in.
TEST(Search, AgreesWithEnumerationOnOtherCutters) {
  std::size_t index = 0;
  for (const Problem& problem :
       oracles::random_problems(kSeed + 16, 70, oracles::Addenda::kSomeStated)) {
    const gearbox::StatedCutters& cutters = problem.cutters;
    if (!cutters.hob_addendum && !cutters.shaper_addendum && !cutters.shaper_teeth) continue;
    expect_agreement(problem, kUses[index % 3], 1 + index % 5);
    ++index;
  }
  EXPECT_GE(index, 20U);
}

// The search cuts off slabs in which planet 2 has no teeth by whatever constraint it meets first,
// here by the shaper's root form: they hold no design, and the checker has to see that.
TEST(Search, CutsOffWhatHoldsNoDesignByAnyConstraint) {
  const Problem problem = problem_in(R"({
      "kind": "gearbox_problem", "version": 1, "topology": "3k", "target_ratio": 27.3,
      "ratio_tolerance": 0.005, "rotor_inner_diameter_mm": 212.3, "ring_outer_diameter_mm": 219.5,
      "module_mm": 1, "planet_count": 3, "min_teeth": {"sun": 51, "planet_1": 12, "planet_2": 19},
      "min_carrier_clearance_rad": 0, "min_contact_ratio": 1.6, "constraints": "buildable",
      "objective": "hollow_shaft", "cutter": {"hob_tip_radius": 0.27, "shaper_addendum": 1.06,
      "shaper_teeth": 32, "shaper_tip_radius": 0.18}})");
  expect_agreement(problem, RelaxationUse::kNever, 1);
}

// The answers, found by enumeration, to problems on which other solvers were seen to be wrong.
TEST(Search, IsRightWhereOthersFail) {
  for (const oracles::HardProblem& hard : oracles::hard_problems()) {
    const gearbox::DesignSearchResult found = gearbox::optimize(hard.problem, {});
    ASSERT_EQ(found.status, gearbox::DesignSearchStatus::kOptimal) << hard.problem.name;
    EXPECT_EQ(found.designs.front().teeth, hard.teeth) << hard.problem.name;
    for (const RelaxationUse use : kUses) expect_agreement(hard.problem, use, 1);
  }
}

// Gears of so few teeth that their meshes do not exist or lose contact: only the paper's
// constraints admit them, and their efficiency is 0 in the search, in the checker and in the
// evaluation.
Problem of_few_teeth(gearbox::Objective objective, std::int64_t ratio, std::int64_t bore) {
  Problem problem = oracles::paper_problem({1, 1, 1}, 0);
  problem.name = fmt::format("few teeth, {}:1, bore of {}", ratio, bore);
  problem.objective = objective;
  problem.target_ratio = ratio;
  problem.ratio_tolerance = io::Rational(1, 20);
  problem.module_mm = {1};
  problem.rotor_inner_diameter_mm = bore;
  problem.planet_count = {2, 3};
  problem.friction_coefficient = io::Rational(9, 10);
  return problem;
}

TEST(Search, AgreesWithEnumerationOnGearsOfFewTeeth) {
  std::size_t index = 0;
  for (const auto objective :
       {gearbox::Objective::kForwardEfficiency, gearbox::Objective::kBackwardEfficiency}) {
    for (const std::int64_t ratio : {4, 8, 20}) {
      for (const std::int64_t bore : {14, 33, 36, 50}) {
        expect_agreement(of_few_teeth(objective, ratio, bore), kUses[index++ % 3], 3);
      }
    }
  }
}

// What the search builds on: whatever meshes with a ring of at least 34 teeth, the least whose tip
// circle lies outside its base circle, is always in contact. Sun and planet reach less than one
// pair only with rings of a few teeth; contact ratios grow with the teeth.
TEST(Search, RingsThatMeshAreAlwaysInContact) {
  for (std::int64_t planet = 1; planet <= 60; ++planet) {
    for (std::int64_t sun = std::max<std::int64_t>(1, 34 - 2 * planet); sun <= 60; ++sun) {
      EXPECT_GT(oracles::external_path(sun, planet).ratio(), 1);
    }
    for (std::int64_t ring = std::max<std::int64_t>(34, planet + 1); ring <= 400; ++ring) {
      EXPECT_GT(oracles::internal_path(planet, ring).ratio(), 1);
    }
  }
}

// The smallest ring among those that the first, too small, domain admits is one of 230 teeth;
// larger planets allow 225, and the proof has to be made for a bore of 225. Where the blanks have
// to fit the bore too, it is larger by root and walls: 2.5 + 4.5 modules.
TEST(Search, ProvesTheSmallestBoreThatWouldDo) {
  Problem problem = problem_in(R"({
      "kind": "gearbox_problem", "version": 1, "name": "too small a bore", "topology": "3k",
      "target_ratio": 35.5, "rotor_inner_diameter_mm": 49.9, "module_mm": 0.7,
      "planet_count": [3, 4, 6], "min_teeth": {"sun": 12, "planet_1": 24, "planet_2": 15},
      "min_carrier_clearance_rad": 0.33, "min_neighbour_clearance_mm": 0.5,
      "ring_outer_diameter_mm": 400, "constraints": "buildable", "objective": "hollow_shaft"})");
  const auto needed_bore_mm = [&] {
    expect_agreement(problem, RelaxationUse::kAuto, 1);
    const auto loosened = gearbox::optimize(problem, {}).would_be_feasible_with;
    EXPECT_EQ(loosened.back().key, "/rotor_inner_diameter_mm");
    return loosened.back().needed;
  };
  EXPECT_EQ(needed_bore_mm(), 157.5);
  problem.ring_outer_diameter_mm.reset();
  EXPECT_EQ(needed_bore_mm(), 162.4);
}

// With six planets the distance between neighbours is a fraction: 0.8 mm. They have to be further
// apart than the limit, so a limit of 0.8 mm would not do.
TEST(Search, NamesAClearanceThatIsExceeded) {
  const Problem problem = problem_in(R"({
      "kind": "gearbox_problem", "version": 1, "name": "crowded", "topology": "3k",
      "target_ratio": 19.2, "rotor_inner_diameter_mm": 43.1, "module_mm": [0.4, 0.5],
      "planet_count": [5, 6], "min_teeth": {"sun": 27, "planet_1": 12, "planet_2": 15},
      "min_carrier_clearance_rad": 0, "min_neighbour_clearance_mm": 1,
      "ring_outer_diameter_mm": 100, "constraints": "buildable", "objective": "hollow_shaft"})");
  expect_agreement(problem, RelaxationUse::kAuto, 1);
  const auto loosened = gearbox::optimize(problem, {}).would_be_feasible_with;
  ASSERT_EQ(loosened.size(), 3u);
  EXPECT_EQ(loosened[2].key, "/min_neighbour_clearance_mm");
  EXPECT_LT(loosened[2].needed, 0.8);
  EXPECT_GT(loosened[2].needed, 0.8 - 1e-12);
  EXPECT_NE(loosened[2].sentence.find("0.7999 mm would do"), std::string::npos);
}

// What is printed of a disagreement has to lead back to it.
TEST(ProblemDocument, ReadsBackAsTheProblem) {
  for (const Problem& problem : oracles::random_problems(kSeed, 100)) {
    const auto document = oracles::problem_document(problem);
    const Problem read =
        gearbox::read_problem(io::check_document(document, "gearbox_problem", "problem.json", ""));
    EXPECT_EQ(oracles::problem_document(read), document);
    EXPECT_EQ(read.target_ratio, problem.target_ratio);
    EXPECT_EQ(read.ratio_tolerance, problem.ratio_tolerance);
    EXPECT_EQ(read.rotor_inner_diameter_mm, problem.rotor_inner_diameter_mm);
    EXPECT_EQ(read.module_mm, problem.module_mm);
    EXPECT_EQ(read.planet_count, problem.planet_count);
    EXPECT_EQ(read.min_teeth, problem.min_teeth);
    EXPECT_EQ(read.min_carrier_clearance_rad, problem.min_carrier_clearance_rad);
    EXPECT_EQ(read.face_width_mm, problem.face_width_mm);
    EXPECT_EQ(read.friction_coefficient, problem.friction_coefficient);
  }
}

// Oracle: closed form. Six planets leave each other m ((S - P)/2 - 2), 3.75:1 makes P 7/8 of S, and
// in a bore of 60 mm 32/28 is the roomiest of 20 teeth or more: exactly 0. Without a
// bound the search for the least change went from double to double around it and never ended.
TEST(Search, EndsWhereTheBestNeighbourClearanceIsZero) {
  const Problem problem = problem_in(R"({"kind": "gearbox_problem", "version": 1,
      "topology": "planetary", "target_ratio": 3.75, "rotor_inner_diameter_mm": 60,
      "module_mm": 0.6, "planet_count": 6, "min_teeth": {"sun": 20, "planet": 20},
      "min_carrier_clearance_rad": 0.01, "constraints": "buildable",
      "objective": "hollow_shaft"})");
  const gearbox::DesignSearchResult found = gearbox::optimize(problem, {});
  EXPECT_EQ(found.status, gearbox::DesignSearchStatus::kInfeasible);
  for (const auto& bound : found.would_be_feasible_with) {
    EXPECT_NE(bound.key, "/min_neighbour_clearance_mm");  // 0 would have to be exceeded
  }
}

// Oracle: closed form. No two external gears of 20 degrees without shift reach a contact ratio of
// 4/(pi sin 40 deg) = 1.9808, so that one constraint conflicts with itself, rings of any size.
Problem with_contact_ratio(const char* ratio) {
  return problem_in(fmt::format(
      R"({{"kind": "gearbox_problem", "version": 1, "topology": "planetary", "target_ratio": 4,
      "ratio_tolerance": 0.01, "rotor_inner_diameter_mm": 80, "module_mm": 0.5, "planet_count": 3,
      "min_teeth": {{"sun": 20, "planet": 20}}, "min_carrier_clearance_rad": 0.01,
      "min_contact_ratio": {}, "constraints": "buildable", "objective": "hollow_shaft"}})",
      ratio));
}

TEST(Search, KnowsWhatNoPairOfGearsReaches) {
  const auto beyond = gearbox::optimize(with_contact_ratio("1.981"), {});
  EXPECT_EQ(beyond.status, gearbox::DesignSearchStatus::kInfeasible);
  ASSERT_EQ(beyond.conflict.size(), 1u);
  EXPECT_EQ(beyond.conflict[0].constraint, "contact_ratio.sun_planet");
  EXPECT_TRUE(beyond.conflict[0].without_it);
  const auto below = gearbox::optimize(with_contact_ratio("1.9799"), {});
  EXPECT_EQ(below.status, gearbox::DesignSearchStatus::kInfeasible);
  EXPECT_GT(below.conflict.size(), 1u);  // only the bore, or the minima, stand in its way
}

// Remedies are legal: within 50 % of 300:1 no gearbox of this bore comes, and no document may ask
// for a wider tolerance.
TEST(Search, NamesOnlyRemediesThatADocumentMayState) {
  const Problem problem = problem_in(R"({"kind": "gearbox_problem", "version": 1,
      "topology": "3k", "target_ratio": 300, "rotor_inner_diameter_mm": 79.4, "module_mm": 0.6,
      "planet_count": 4, "min_teeth": {"sun": 40, "planet_1": 30, "planet_2": 30},
      "min_carrier_clearance_rad": 0.05, "constraints": "paper", "objective": "paper_cost"})");
  const gearbox::DesignSearchResult found = gearbox::optimize(problem, {});
  ASSERT_EQ(found.status, gearbox::DesignSearchStatus::kInfeasible);
  ASSERT_FALSE(found.would_be_feasible_with.empty());
  for (const auto& bound : found.would_be_feasible_with) EXPECT_NE(bound.key, "/ratio_tolerance");
}

// A design named with a conflict misses one constraint and no other, wherever there is one. Oracle:
// the enumeration of the problem without that constraint.
TEST(Search, NamesDesignsThatMissNothingElse) {
  int named = 0;
  for (const Problem& problem : oracles::random_problems(kSeed + 7, 240)) {
    const gearbox::DesignSearchResult found = gearbox::optimize(problem, {});
    for (const auto& member : found.conflict) {
      if (member.constraint != "carrier_clearance" || !member.without_it) continue;
      Problem loosened = problem;
      loosened.min_carrier_clearance_rad = 0;
      if (oracles::enumerate(loosened).feasible.empty()) continue;
      for (const auto& each : gearbox::find_topology(problem.topology)
                                  ->evaluate(problem, *member.without_it)
                                  .constraints) {
        EXPECT_EQ(each.satisfied, each.name != "carrier_clearance") << problem.name << each.name;
      }
      ++named;
    }
  }
  EXPECT_GT(named, 5);
}

}  // namespace
}  // namespace torquewright::search_test
