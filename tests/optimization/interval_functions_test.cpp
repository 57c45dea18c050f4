// SPDX-License-Identifier: Apache-2.0
// Roots and angles. Oracle: MPFR at 400 bits, on members of the interval.
#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <string>

#include "tests/optimization/random_intervals.hpp"

namespace torquewright::optimization {
namespace {

constexpr int kMembersTried = 400;

struct Function {
  std::string name;
  std::function<Interval(Interval)> enclose;
  std::function<Rational(const Rational&)> exact;
  double domain_lower, domain_upper;
};

const std::vector<Function>& functions() {
  static const std::vector<Function> all{
      {"sqrt", [](Interval a) { return sqrt(a); }, true_sqrt, 0.0, kInfinity},
      {"asin", [](Interval a) { return asin(a); }, true_asin, -1.0, 1.0},
      {"acos", [](Interval a) { return acos(a); }, true_acos, -1.0, 1.0},
      {"atan", [](Interval a) { return atan(a); }, true_atan, -kInfinity, kInfinity},
  };
  return all;
}

void expect_enclosed(const Function& function, const Interval& argument) {
  const Interval result = function.enclose(argument);
  int inside = 0;
  for (const Rational& x : members(argument)) {
    if (!encloses({function.domain_lower, function.domain_upper}, x)) continue;
    ++inside;
    ASSERT_TRUE(encloses(result, function.exact(x))) << function.name << " " << x;
  }
  const bool is_outside =
      argument.upper < function.domain_lower || argument.lower > function.domain_upper;
  EXPECT_EQ(is_nowhere(result), is_outside) << function.name;
  EXPECT_TRUE(inside > 0 || is_outside || is_nowhere(result) || result.lower <= result.upper);
}

TEST(IntervalFunctions, EncloseMembersOfTheDomain) {
  Dice dice(11);
  for (int trial = 0; trial < kMembersTried; ++trial) {
    const Interval inner = draw_between(dice, -1.0, 1.0), outer = draw_between(dice, -2.0, 2.0);
    for (const Function& function : functions()) {
      expect_enclosed(function, inner);
      expect_enclosed(function, outer);  // partly or wholly outside, now and then
      expect_enclosed(function, draw_interval(dice, 200));
    }
  }
}

TEST(IntervalFunctions, AtTheEndsOfTheDomain) {
  const double below_one = std::nextafter(1.0, 0.0),
               least = std::numeric_limits<double>::denorm_min();
  for (const Function& function : functions()) {
    for (const double x : {0.0, -0.0, 1.0, -1.0, below_one, -below_one, least, 0.5}) {
      expect_enclosed(function, Interval(x));
      expect_enclosed(function, Interval(-2.0, x));
      expect_enclosed(function, Interval(x, 2.0));
    }
  }
}

TEST(IntervalFunctions, NowhereJustOutsideTheDomain) {
  EXPECT_TRUE(is_nowhere(sqrt(Interval(-1.0, -std::numeric_limits<double>::denorm_min()))));
  for (const double outside : {std::nextafter(1.0, 2.0), std::nextafter(-1.0, -2.0)}) {
    EXPECT_TRUE(is_nowhere(asin(Interval(outside))));
    EXPECT_TRUE(is_nowhere(acos(Interval(outside))));
  }
}

TEST(IntervalFunctions, OfTheWholeLine) {
  const Interval line(-kInfinity, kInfinity);
  EXPECT_TRUE(encloses(sqrt(line), 0));
  EXPECT_EQ(sqrt(line).upper, kInfinity);
  EXPECT_TRUE(encloses(asin(line), true_asin(1)) && encloses(asin(line), true_asin(-1)));
  EXPECT_TRUE(encloses(acos(line), true_acos(1)) && encloses(acos(line), true_acos(-1)));
  EXPECT_TRUE(encloses(atan(line), true_pi() / 2) && encloses(atan(line), -true_pi() / 2));
}

}  // namespace
}  // namespace torquewright::optimization
