// SPDX-License-Identifier: Apache-2.0
// gearbox::standing_of, that is rank and `optimal_when`, against the enumeration.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "gearbox/search/ranking.hpp"
#include "gearbox/search/result_spec.hpp"
#include "gearbox/topologies/topology.hpp"
#include "io/documents/document.hpp"
#include "tests/oracles/dice.hpp"
#include "tests/oracles/gearbox_enumeration.hpp"
#include "tests/oracles/named_problems.hpp"
#include "tests/oracles/random_problems.hpp"

namespace torquewright::oracles {
namespace {

using gearbox::Design;
using gearbox::Objective;
using gearbox::OptimalWhen;
using gearbox::Problem;
using gearbox::Standing;

// As in Ties.BeginBelowOneInAMillionMillions: what differs by less is as good.
constexpr long double kTie = 1e-12L;

Standing standing(const Problem& problem, const Design& design) {
  return gearbox::standing_of(problem, design, {});
}

bool is_maximised(Objective objective) {
  return objective == Objective::kHollowShaft || objective == Objective::kForwardEfficiency ||
         objective == Objective::kBackwardEfficiency;
}

// Clearly better: by more than what counts as a tie.
bool beats(const Problem& problem, const Found& a, const Found& b) {
  const long double gain =
      is_maximised(problem.objective) ? a.objective - b.objective : b.objective - a.objective;
  return gain > kTie * std::max(std::abs(a.objective), std::abs(b.objective));
}

bool ties(const Problem& problem, const Found& a, const Found& b) {
  return !beats(problem, a, b) && !beats(problem, b, a);
}

long double clearance_rad(const Found& found) {
  const auto planet = static_cast<long double>(found.teeth.planet_1);
  return std::numbers::pi_v<long double> / static_cast<long double>(found.planet_count) -
         std::asin(planet / (static_cast<long double>(found.teeth.sun) + planet));
}

TEST(Rank, IsTheNumberOfBetterDesignsPlusOne) {
  Dice dice(31);
  int ranked = 0, beyond_first = 0;
  for (const Problem& problem : random_problems(41, 120)) {
    const Enumeration all = enumerate(problem);
    if (!all.near_ties.empty() || all.feasible.empty() || all.feasible.size() > 2000) continue;
    for (int pick = 0; pick < 3; ++pick) {
      const Found& found = dice.one_of(all.feasible);
      std::int64_t better = 0;
      std::size_t equal = 0;
      for (const Found& other : all.feasible) {
        better += beats(problem, other, found) ? 1 : 0;
        equal += ties(problem, other, found) ? 1 : 0;
      }
      const Standing result = standing(problem, to_design(problem, found));
      ASSERT_TRUE(result.is_settled);
      ASSERT_EQ(result.feasible_count, static_cast<std::int64_t>(all.feasible.size()))
          << problem.name;
      ASSERT_EQ(result.rank, better + 1) << problem.name;
      EXPECT_EQ(result.ties.size() + 1, equal) << problem.name;
      const double best = static_cast<double>(all.best.front().objective);
      EXPECT_NEAR(*result.best_objective, best, 1e-11 * std::abs(best)) << problem.name;
      ++ranked;
      beyond_first += better > 0 ? 1 : 0;
    }
  }
  EXPECT_GT(ranked, 60);
  EXPECT_GT(beyond_first, 20);
}

TEST(Rank, IsAbsentForADesignThatIsNotFeasible) {
  const Standing result = standing(d151_problem(), {{24, 48, 28, 120, 100}, 4, Rational(3, 5)});
  EXPECT_FALSE(result.rank);
  EXPECT_EQ(result.feasible_count, 1);
  // it breaks minima and clearance only, so something can be said of them
  EXPECT_FALSE(result.optimal_when.empty());
  const Standing other = standing(d151_problem(), {{44, 44, 31, 132, 119}, 4, Rational(3, 5)});
  EXPECT_FALSE(other.rank);
  EXPECT_TRUE(other.optimal_when.empty());  // 20:1 is missed, whatever the minima
}

// minlp.md section 7: the published design, n = 4, exactly 20:1.
TEST(OptimalWhen, OfThePublishedDesignIsSectionSeven) {
  const std::vector<OptimalWhen> ranges =
      standing(d151_problem(), {{44, 44, 32, 132, 120}, 4, Rational(3, 5)}).optimal_when;
  using Least = std::vector<std::vector<std::int64_t>>;
  const Least up_to_3_19{{0, 0, 29},  {25, 43, 0}, {31, 41, 0}, {35, 0, 28},
                         {35, 37, 0}, {43, 0, 26}, {43, 33, 0}};
  const Least up_to_9_31{{0, 0, 29},  {0, 43, 0},  {31, 41, 0}, {35, 0, 28},
                         {35, 37, 0}, {43, 0, 26}, {43, 33, 0}};
  const Least up_to_12_28{{0, 0, 29},  {0, 41, 0},  {35, 0, 28},
                          {35, 37, 0}, {43, 0, 26}, {43, 33, 0}};
  const Least up_to_15{{0, 0, 28}, {0, 37, 0}, {43, 0, 26}, {43, 33, 0}};
  ASSERT_EQ(ranges.size(), 4u);
  const Least* expected[] = {&up_to_3_19, &up_to_9_31, &up_to_12_28, &up_to_15};
  // pi/4 - asin(48/72) = 3.19 degrees shuts out 24/48/28; 15 degrees are the design's own
  const double ends[] = {std::asin(48. / 72), 0, 0, std::asin(.5)};
  for (std::size_t i = 0; i < 4; ++i) {
    auto least = ranges[i].least_minima;
    auto wanted = *expected[i];
    std::sort(least.begin(), least.end());
    std::sort(wanted.begin(), wanted.end());
    EXPECT_EQ(least, wanted) << i;
    EXPECT_EQ(ranges[i].from_zero, i == 0);
    if (i > 0) {
      EXPECT_EQ(ranges[i].clearance_above_rad, ranges[i - 1].clearance_up_to_rad);
    }
    if (i == 0 || i == 3) {
      EXPECT_NEAR(ranges[i].clearance_up_to_rad, std::numbers::pi / 4 - ends[i], 1e-15);
    }
  }
}

Problem with_bounds(Problem problem, const std::vector<std::int64_t>& minima, double alpha_rad) {
  const bool three_k = problem.topology == "3k";
  problem.min_teeth["sun"] = std::max<std::int64_t>(1, minima[0]);
  problem.min_teeth[three_k ? "planet_1" : "planet"] = std::max<std::int64_t>(1, minima[1]);
  if (three_k) problem.min_teeth["planet_2"] = std::max<std::int64_t>(1, minima[2]);
  problem.min_carrier_clearance_rad = io::exact(alpha_rad);
  return problem;
}

// Oracle: run the enumeration again with these bounds; the design is among the best, or it is not.
bool is_optimum(const Problem& problem, const std::vector<std::int64_t>& minima, double alpha_rad,
                const Design& design) {
  const Problem bounded = with_bounds(problem, minima, alpha_rad);
  for (const Found& found : enumerate(bounded).best) {
    if (to_design(bounded, found) == design) return true;
  }
  return false;
}

// Far more than the rounding of an angle, far less than the distance of two clearances.
constexpr double kBeyond_rad = 1e-9;

void expect_limits_are_sharp(const Problem& problem, const Design& design) {
  const std::vector<OptimalWhen> ranges = standing(problem, design).optimal_when;
  for (const OptimalWhen& when : ranges) {
    if (when.clearance_up_to_rad - when.clearance_above_rad < 4 * kBeyond_rad) continue;
    const double inside = when.clearance_up_to_rad - kBeyond_rad;
    const double least_inside = when.from_zero ? 0.0 : when.clearance_above_rad + kBeyond_rad;
    for (const auto& least : when.least_minima) {
      ASSERT_TRUE(is_optimum(problem, least, inside, design)) << problem.name;
      ASSERT_TRUE(is_optimum(problem, least, least_inside, design)) << problem.name;
      for (std::size_t gear = 0; gear < least.size(); ++gear) {
        if (least[gear] == 0) continue;
        std::vector<std::int64_t> less = least;
        less[gear] -= 1;
        ASSERT_FALSE(is_optimum(problem, less, inside, design)) << problem.name;
        std::vector<std::int64_t> too_many = least;
        too_many[gear] = design.teeth[gear] + 1;
        ASSERT_FALSE(is_optimum(problem, too_many, inside, design)) << problem.name;
      }
    }
  }
  if (ranges.empty()) return;
  std::vector<std::int64_t> own(ranges.front().least_minima.empty()
                                    ? gearbox::find_topology(problem.topology)->free_gears
                                    : ranges.front().least_minima.front().size());
  std::copy_n(design.teeth.begin(), own.size(), own.begin());
  const double too_much = ranges.back().clearance_up_to_rad + kBeyond_rad;
  ASSERT_FALSE(is_optimum(problem, own, too_much, design)) << problem.name;
}

TEST(OptimalWhen, HoldsInsideItsLimitsAndNotJustBeyond) {
  expect_limits_are_sharp(d151_problem(), {{44, 44, 32, 132, 120}, 4, Rational(3, 5)});
  expect_limits_are_sharp(d151_problem(), {{24, 48, 28, 120, 100}, 4, Rational(3, 5)});
  Dice dice(32);
  int tried = 0;
  for (const Problem& problem : random_problems(42, 80)) {
    const Enumeration all = enumerate(with_bounds(problem, {1, 1, 1}, 0.0));
    if (!all.near_ties.empty() || all.feasible.empty() || all.feasible.size() > 300) continue;
    expect_limits_are_sharp(problem, to_design(problem, dice.one_of(all.feasible)));
    ++tried;
  }
  EXPECT_GT(tried, 10);
}

// Oracle: any minima at all, drawn at random: optimum exactly if one of the least is reached.
TEST(OptimalWhen, IsComplete) {
  Dice dice(33);
  int yes = 0, no = 0;
  for (const Problem& problem : random_problems(43, 80)) {
    const Enumeration all = enumerate(with_bounds(problem, {1, 1, 1}, 0.0));
    if (!all.near_ties.empty() || all.feasible.empty() || all.feasible.size() > 300) continue;
    const Found& own = dice.one_of(all.feasible);
    const Design design = to_design(problem, own);
    const std::vector<OptimalWhen> ranges = standing(problem, design).optimal_when;
    const std::size_t gears = gearbox::find_topology(problem.topology)->free_gears;
    for (const OptimalWhen& when : ranges) {
      const double alpha_rad = (when.clearance_above_rad + when.clearance_up_to_rad) / 2;
      for (int draw = 0; draw < 200; ++draw) {
        std::vector<std::int64_t> minima(gears);
        for (std::size_t gear = 0; gear < gears; ++gear) {
          minima[gear] = dice.between(1, design.teeth[gear]);
        }
        const auto reaches = [&](const std::vector<std::int64_t>& least) {
          return std::equal(least.begin(), least.end(), minima.begin(),
                            [](auto needed, auto given) { return given >= needed; });
        };
        const bool stated =
            std::any_of(when.least_minima.begin(), when.least_minima.end(), reaches);
        bool is_beaten = false;
        for (const Found& other : all.feasible) {
          const std::vector<std::int64_t> teeth = to_design(problem, other).teeth;
          is_beaten |= beats(problem, other, own) &&
                       static_cast<double>(clearance_rad(other)) >= alpha_rad &&
                       std::equal(minima.begin(), minima.end(), teeth.begin(),
                                  [](auto minimum, auto count) { return count >= minimum; });
        }
        ASSERT_EQ(stated, !is_beaten) << problem.name;
        (stated ? yes : no) += 1;
      }
    }
  }
  EXPECT_GT(yes, 500);
  EXPECT_GT(no, 500);
}

// An evaluation is a document of the kind it names.
TEST(Evaluation, IsAGearboxResult) {
  const Problem problem = d151_problem();
  for (const Design& design : {Design{{44, 44, 32, 132, 120}, 4, Rational(3, 5)},
                               Design{{24, 48, 28, 120, 100}, 4, Rational(3, 5)}}) {
    const gearbox::Topology& topology = *gearbox::find_topology(problem.topology);
    nlohmann::json result =
        nlohmann::json::parse(gearbox::evaluation_json(problem, topology.evaluate(problem, design),
                                                       standing(problem, design))
                                  .dump());
    result["problem"] =
        io::read_document(std::string(TORQUEWRIGHT_SOURCE_DIR) + "/specs/gearbox/d151_knee.json",
                          "gearbox_problem")
            .root;
    result["tool"] = {{"name", "torquewright"}, {"version", "0"}};
    result["inputs"] = nlohmann::json::array();
    EXPECT_NO_THROW(io::check_document(result, "gearbox_result", "r", ""));
    EXPECT_EQ(result["rank"].is_null(), design.teeth[0] == 24);
  }
}

}  // namespace
}  // namespace torquewright::oracles
