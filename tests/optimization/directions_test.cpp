// SPDX-License-Identifier: Apache-2.0
// What the models of gearboxes state of their conditions: how the bodies change with a variable.
// Oracle: the ratio in exact fractions, and neighbouring points of the domain.
#include <gtest/gtest.h>

#include <map>

#include "gearbox/topologies/planetary_model.hpp"
#include "gearbox/topologies/three_k_model.hpp"
#include "optimization/discrete/judge.hpp"
#include "tests/optimization/boxes.hpp"

namespace torquewright::optimization {
namespace {

using Point = std::vector<std::int64_t>;

constexpr std::int64_t kRingLimit = 132;
constexpr std::int64_t kPlanets = 4;
const Rational kModule_mm(3, 5);

gearbox::Problem problem_of(const std::string& topology, const Rational& ratio,
                            const Rational& tolerance) {
  gearbox::Problem problem;
  problem.topology = topology;
  problem.target_ratio = ratio;
  problem.ratio_tolerance = tolerance;
  problem.rotor_inner_diameter_mm = Rational(397, 5);
  problem.module_mm = {kModule_mm};
  problem.planet_count = {kPlanets};
  problem.min_teeth = {{"sun", 12}, {"planet_1", 12}, {"planet_2", 12}, {"planet", 12}};
  problem.min_carrier_clearance_rad = Rational(1, 10);
  problem.constraints = gearbox::ConstraintSet::kBuildable;
  problem.objective = gearbox::Objective::kHollowShaft;
  problem.ring_outer_diameter_mm = 90;
  return problem;
}

Problem model_of(const gearbox::Problem& problem) {
  return problem.topology == "3k"
             ? gearbox::three_k::model(problem, kPlanets, kModule_mm, kRingLimit)
             : gearbox::planetary::model(problem, kPlanets, kModule_mm, kRingLimit);
}

/// The corners of what documents may ask for: ratios from 1 to 10000, tolerances up to one half.
std::vector<gearbox::Problem> all_problems() {
  std::vector<gearbox::Problem> problems;
  for (const char* topology : {"3k", "planetary"}) {
    for (const Rational& ratio :
         {Rational(1), Rational(6, 5), Rational(5, 2), Rational(20), Rational(10000)}) {
      for (const Rational& tolerance : {Rational(0), Rational(1, 100), Rational(1, 2)}) {
        problems.push_back(problem_of(topology, ratio, tolerance));
      }
    }
  }
  return problems;
}

Point draw_point(Dice& dice, const Box& domain) {
  Point point;
  for (const Range& range : domain) point.push_back(dice.between(range.lower, range.upper));
  return point;
}

TEST(Directions, AreTrueOfNeighbours) {
  Dice dice(171);
  int stated = 0;
  for (const gearbox::Problem& problem : all_problems()) {
    const Problem model = model_of(problem);
    for (const Condition& condition : model.conditions) {
      if (condition.directions.empty()) continue;
      ASSERT_EQ(condition.directions.size(), model.variables.size());
      const Formula body(condition.body);
      for (int trial = 0; trial < 150; ++trial) {
        const Point point = draw_point(dice, model.domain);
        for (std::size_t i = 0; i < point.size(); ++i) {
          if (condition.directions[i] == Direction::kUnknown) continue;
          ++stated;
          Point next = point;
          next[i] = dice.between(point[i], model.domain[i].upper);
          const PreciseInterval rise = body.precisely_at(next) - body.precisely_at(point);
          ASSERT_FALSE(condition.directions[i] == Direction::kGrows ? rise.is_negative()
                                                                    : rise.is_positive())
              << condition.name << " " << model.variables[i] << " at " << point[0] << "/"
              << point[1] << "/" << point.back() << ", ratio " << problem.target_ratio << " +- "
              << problem.ratio_tolerance;
        }
      }
    }
  }
  EXPECT_GT(stated, 1000);
}

// On boxes, a body is judged by what it states, or as a linear form: then its corners decide.
TEST(Directions, BoxesAreRefutedOnlyIfNoPointHolds) {
  Dice dice(172);
  std::map<std::string, int> refuted;
  for (const gearbox::Problem& problem : all_problems()) {
    const Problem model = model_of(problem);
    const Judge judge(model);
    for (int trial = 0; trial < 60; ++trial) {
      Box box;
      for (const Range& range : model.domain) {
        const std::int64_t lower = dice.between(range.lower, range.upper);
        box.push_back({lower, std::min(range.upper, lower + dice.between(0, 30))});
      }
      for (std::size_t i = 0; i < judge.condition_count(); ++i) {
        if (!judge.on_boxes(i) || !judge.refutes(i, box)) continue;
        ++refuted[judge.condition(i).name];
        for (int sample = 0; sample < 8; ++sample) {
          ASSERT_FALSE(judge.holds(i, draw_point(dice, box))) << judge.condition(i).name;
        }
        for (const RealPoint& corner : corners(box)) {
          Point point;
          for (const Rational& value : corner) point.push_back(value.get_num().get_si());
          ASSERT_FALSE(judge.holds(i, point)) << judge.condition(i).name;
        }
      }
    }
  }
  EXPECT_GT(refuted["ratio_max"], 20);
  EXPECT_GT(refuted["ratio_min"], 20);
  EXPECT_GT(refuted.size(), 12u);
}

/// 3k: i = 2 P1 O/(S d) with O = S + 2 P1 - d; a single stage: i = 2 (S + P)/S.
Rational ratio_at(const std::string& topology, const Point& point) {
  const Rational sun(point[0]), planet(point[1]);
  if (topology == "planetary") return 2 * (sun + planet) / sun;
  const Rational difference(point[2]);
  return 2 * planet * (sun + 2 * planet - difference) / (sun * difference);
}

// The conditions say G(1-t) <= i <= G(1+t), on all designs (planet 2 has teeth).
TEST(Directions, RatioConditionsAreTheRatio) {
  Dice dice(173);
  for (const gearbox::Problem& problem : all_problems()) {
    const Problem model = model_of(problem);
    const Judge judge(model);
    for (int trial = 0; trial < 300; ++trial) {
      const Point point = draw_point(dice, model.domain);
      if (problem.topology == "3k" && point[2] >= point[1]) continue;
      const Rational ratio = ratio_at(problem.topology, point);
      for (std::size_t i = 0; i < judge.condition_count(); ++i) {
        const Rational limit = problem.target_ratio;
        if (judge.condition(i).name == "ratio_max") {
          ASSERT_EQ(judge.holds(i, point), ratio <= limit * (1 + problem.ratio_tolerance));
        } else if (judge.condition(i).name == "ratio_min") {
          ASSERT_EQ(judge.holds(i, point), ratio >= limit * (1 - problem.ratio_tolerance));
        }
      }
    }
  }
}

}  // namespace
}  // namespace torquewright::optimization
