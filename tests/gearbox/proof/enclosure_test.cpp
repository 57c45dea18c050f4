// SPDX-License-Identifier: Apache-2.0
// What the checker concludes for whole boxes holds for the designs in them. Oracle: the plain
// formulas in doubles, at single designs.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "gearbox/proof/gears/efficiency.hpp"
#include "gearbox/proof/relaxation/concave_forms.hpp"
#include "gearbox/proof/relaxation/relaxation.hpp"
#include "gearbox/proof/tree/refutation.hpp"
#include "tests/gearbox/proof/naive_result.hpp"

namespace torquewright::gearbox::proof_test {
namespace {

using proof::Alternative;
using proof::Box;
using proof::Interval;
using proof::Point;

/// A few roundings of a double in the oracle.
constexpr double kRounding = 1e-12;

/// Up to `spread` teeth wide in each variable.
Box random_box(std::mt19937& random, bool planetary, long spread) {
  const auto draw = [&](long least, long most) {
    return std::uniform_int_distribution<long>(least, most)(random);
  };
  Box box{{draw(4, 70), draw(4, 50), planetary ? 0 : draw(1, 25)}, {}};
  for (std::size_t i = 0; i < 3; ++i) {
    box.upper[i] = planetary && i == 2 ? 0 : box.lower[i] + draw(0, spread);
  }
  return box;
}

PlainPoint random_point(std::mt19937& random, const Box& box) {
  PlainPoint point;
  for (std::size_t i = 0; i < 3; ++i) {
    point[i] = std::uniform_int_distribution<long>(box.lower[i], box.upper[i])(random);
  }
  return point;
}

bool contains(const Interval& interval, double value) {
  const Interval slack = Rational(kRounding * (std::abs(value) + 1));
  const Interval difference = interval - Interval(Rational(value));
  return !(difference.lower() - slack).certainly_positive() &&
         !(difference.upper() + slack).certainly_negative();
}

proof::Quantity quantity_of(const std::string& name) {
  using proof::Measure;
  if (name == "carrier_clearance") return {Measure::kCarrierClearance};
  if (name == "ring_pitch_diameter_mm") return {Measure::kRingPitchDiameter};
  if (name == "ratio_error") return {Measure::kRatioError};
  if (name == "contact_ratio") return {Measure::kContactRatio};
  if (name == "neighbour_clearance_mm") return {Measure::kNeighbourClearance};
  if (name == "ring_blank_diameter_mm") return {Measure::kRingBlankDiameter};
  if (name == "paper_cost") return {Measure::kPaperCost};
  if (name == "mass") return {Measure::kMass};
  if (name == "hollow_shaft") return {Measure::kHollowShaft};
  if (name == "forward_efficiency") return {Measure::kForwardEfficiency};
  if (name == "backward_efficiency") return {Measure::kBackwardEfficiency};
  if (name == "reflected_inertia") return {Measure::kReflectedInertia};
  return {Measure::kTeeth, name == "teeth.sun" ? 0 : name == "teeth.planet_2" ? 2 : 1};
}

Problem widened(const Problem& base) {
  Problem problem = base;
  problem.ratio_tolerance = Rational(1, 4);
  problem.friction_coefficient = Rational(1, 10);
  return problem;
}

void expect_enclosed(const Problem& problem, const std::string& name) {
  std::mt19937 random(7);
  const Alternative alternative(problem, 3, Rational(3, 5));
  const Choice choice{&problem, 3, 0.6};
  const Interval allowed(alternative.least_ratio, alternative.greatest_ratio);
  int designs = 0;
  for (int trial = 0; trial < 3000; ++trial) {
    const Box box = random_box(random, is_planetary(problem), trial % 2 == 0 ? 0 : 12);
    const PlainPoint point = random_point(random, box);
    const Gears gears = gears_at(point);
    if (gears.second < 1 || !holds("ratio", choice, gears)) continue;
    ++designs;
    const Interval enclosure = proof::enclosure_on(quantity_of(name), alternative, box, allowed);
    const double value = quantity(name, choice, gears);
    ASSERT_TRUE(contains(enclosure, value))
        << name << " " << gears.sun << " " << gears.first << " " << gears.second;
    const auto at = proof::value_at(quantity_of(name), alternative, {point[0], point[1], point[2]});
    ASSERT_TRUE(contains(at.enclosure, value)) << name;
  }
  EXPECT_GT(designs, 20) << name;
}

TEST(Enclosure, HoldsEveryDesignOfABox) {
  for (const char* name :
       {"paper_cost", "mass", "hollow_shaft", "forward_efficiency", "backward_efficiency",
        "reflected_inertia", "teeth.sun", "teeth.planet_1", "teeth.planet_2", "carrier_clearance",
        "ring_pitch_diameter_mm", "ratio_error", "contact_ratio", "neighbour_clearance_mm",
        "ring_blank_diameter_mm"}) {
    expect_enclosed(widened(buildable_inertia()), name);
  }
}

TEST(Enclosure, HoldsEveryPlanetaryDesignOfABox) {
  Problem problem = widened(planetary_8());
  problem.target_ratio = 4;
  for (const char* name :
       {"mass", "hollow_shaft", "forward_efficiency", "backward_efficiency", "reflected_inertia",
        "carrier_clearance", "ratio_error", "contact_ratio", "neighbour_clearance_mm"}) {
    expect_enclosed(problem, name);
  }
}

// Oracle: a box is refuted only if no design in it satisfies the condition; constraints are linear
// or monotone, so that on a box of designs the reverse holds too.
void expect_refutations(const StatedCutters& cutters) {
  Problem problem = widened(buildable_inertia());
  problem.min_contact_ratio = Rational(8, 5);  // small gears miss it
  problem.cutters = cutters;
  std::mt19937 random(3);
  proof::Claim claim;
  claim.hypotheses = proof::constraints_of(problem);
  const Alternative alternative(problem, 4, Rational(3, 5));
  const Choice choice{&problem, 4, 0.6};
  std::map<std::string, int> refuted, missed;
  for (int trial = 0; trial < 4000; ++trial) {
    const Box box = random_box(random, false, 5);
    if (box.lower[1] <= box.upper[2]) continue;  // designs only
    for (std::string name : constraint_names(problem)) {
      for (const char* side : {"_max", "_min"}) {
        const std::string condition = name == "ratio" ? name + side : name;
        const auto found = proof::find_condition(claim, condition);
        if (!found) continue;
        bool none = true;
        proof::for_each_point(box, [&](const Point& point) {
          const Gears g = gears_at({point[0], point[1], point[2]});
          const double error = ratio(choice, g) / number(problem.target_ratio) - 1;
          none = name != "ratio" ? !holds(name, choice, g)
                                 : (condition == "ratio_max" ? error > 0.25 : error < -0.25);
          return none;
        });
        proof::Budget budget;
        const bool shown = proof::refutes(claim, alternative, *found, box, budget);
        ASSERT_TRUE(none || !shown) << condition;
        refuted[condition] += shown ? 1 : 0;
        missed[condition] += none && !shown ? 1 : 0;
      }
    }
  }
  for (const auto& [condition, count] : refuted) {
    EXPECT_GT(count, 0) << condition;
    EXPECT_EQ(missed[condition], 0) << condition;
  }
}

TEST(Refutation, AgreesWithJudgingEveryPoint) {
  expect_refutations({Rational(1, 5), Rational(1, 5), 14});
}

// A hob too short for its rounding, a shaper that has the planet's teeth, and one that is too large
// for small rings.
TEST(Refutation, AgreesWithJudgingEveryPointForOtherAddenda) {
  expect_refutations({Rational(39, 100), Rational(3, 10), {}, Rational(23, 20), Rational(23, 20)});
  expect_refutations({{}, {}, 30, Rational(6, 5), Rational(7, 5)});
}

// The linearisation of a concave h_c at any point lies above h_c, which lies above g_c: at a design
// that satisfies the condition it is not negative. Its value is the plain one.
TEST(ConcaveForm, NeverRefutesWhatSatisfiesIt) {
  Problem problem = widened(buildable_inertia());
  problem.objective = Objective::kPaperCost;
  problem.cutters = {Rational(1, 5), Rational(1, 5), 14};
  std::mt19937 random(5);
  proof::Claim claim;
  claim.hypotheses = proof::constraints_of(problem);
  claim.hypotheses.push_back({"positive_teeth", proof::ConstraintFamily::kPositiveTeeth, 0, ""});
  const Alternative alternative(problem, 4, Rational(3, 5));
  const Choice choice{&problem, 4, 0.6};
  PlainClaim plain{&problem, "optimum", {}, "", PlainDesign{{44, 44, 32}, 4, 0.6}, {}, "", 0};
  std::vector<std::string> conditions{"ratio_max", "ratio_min", "positive_teeth", "quantity"};
  for (const std::string& name : constraint_names(problem)) {
    const bool has_form = !name.starts_with("contact_ratio.") && !name.starts_with("root_form.");
    if (has_form && proof::find_condition(claim, name)) conditions.push_back(name);
  }
  std::map<std::string, int> judged;
  for (int trial = 0; trial < 4000; ++trial) {
    const Box box = random_box(random, false, 12);
    const PlainPoint at = random_point(random, box), y = random_point(random, box);
    const Gears g = gears_at(at);
    if (g.second < 1) continue;
    for (const char* objective : {"paper_cost", "mass", "hollow_shaft", "forward_efficiency"}) {
      plain.quantity = objective;
      claim.quantity = quantity_of(objective);
      claim.threshold = proof::value_at(*claim.quantity, alternative, {44, 44, 12});
      for (const std::string& name : conditions) {
        if (name != "quantity" && plain.quantity != "mass") continue;  // once is enough
        const bool met = name == "quantity"
                             ? holds("ratio", choice, g) && against_reference(plain, choice, g) >= 0
                             : name == "positive_teeth" ||
                                   holds(name.rfind("ratio_", 0) == 0 ? "ratio" : name, choice, g);
        if (!met) continue;
        const proof::RealPoint point{Rational(y[0]), Rational(y[1]), Rational(y[2])};
        const auto form =
            proof::linearize(claim, alternative, *proof::find_condition(claim, name), box, point);
        ASSERT_TRUE(form) << name;
        if (name != "quantity" || plain.quantity == "paper_cost") {
          const PlainBox same{{box.lower[0], box.lower[1], box.lower[2]},
                              {box.upper[0], box.upper[1], box.upper[2]}};
          const double expected = concave_form(
              name, plain, choice, same,
              {static_cast<double>(y[0]), static_cast<double>(y[1]), static_cast<double>(y[2])});
          ASSERT_TRUE(contains(form->value, expected)) << name;
        }
        Interval value = form->value;
        for (std::size_t i = 0; i < 3; ++i) value += form->gradient[i] * Interval(at[i] - y[i]);
        ASSERT_FALSE((value + Interval(Rational(1, 1000000000))).certainly_negative()) << name;
        ++judged[name + " " + objective];
      }
    }
  }
  EXPECT_GE(judged.size(), conditions.size() + 3);
}

// reference/gearbox.md sections 5, 6 and 12: efficiencies with the general loss integral, contact
// ratios of both ring meshes.
TEST(Formulas, AgreeWithPublishedNumbers) {
  Problem problem = d151();
  const Alternative alternative(problem, 4, Rational(3, 5));
  const auto near = [](const Interval& value, double expected, double tolerance) {
    return (proof::abs(value - Interval(Rational(expected))) - Interval(Rational(tolerance)))
        .certainly_negative();
  };
  const auto of = [&](const std::string& name, const Point& point, const Alternative& where) {
    return proof::value_at(quantity_of(name), where, point).enclosure;
  };
  EXPECT_TRUE(near(of("forward_efficiency", {44, 44, 12}, alternative), 0.9568, 5e-5));
  EXPECT_TRUE(near(of("backward_efficiency", {44, 44, 12}, alternative), 0.9552, 5e-5));
  problem.friction_coefficient = Rational(3, 10);
  EXPECT_TRUE(near(of("forward_efficiency", {36, 32, 4}, alternative), 0.6737, 5e-5));
  EXPECT_TRUE(near(of("backward_efficiency", {36, 32, 4}, alternative), 0.5372, 5e-5));
}

}  // namespace
}  // namespace torquewright::gearbox::proof_test
