// SPDX-License-Identifier: Apache-2.0
// Oracle: the functions of <cmath> at points of the box.
#include "gearbox/sized_proof/enclosures/affine.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <random>

namespace torquewright::gearbox::sized {
namespace {

struct Case {
  const char* name;
  double low, high;  ///< Of the argument.
  std::function<Affine(const Affine&)> enclosed;
  std::function<double(double)> at;
};

const std::vector<Case>& cases() {
  static const std::vector<Case> list{
      {"reciprocal", 0.1, 9.0, [](const Affine& x) { return 1.0 / x; },
       [](double x) { return 1.0 / x; }},
      {"reciprocal below", -9.0, -0.1, [](const Affine& x) { return 1.0 / x; },
       [](double x) { return 1.0 / x; }},
      {"squared", -3.0, 3.0, [](const Affine& x) { return squared(x); },
       [](double x) { return x * x; }},
      {"root", 0.0, 9.0, [](const Affine& x) { return root(x); },
       [](double x) { return std::sqrt(x); }},
      {"exponential", -3.0, 3.0, [](const Affine& x) { return exponential(x); },
       [](double x) { return std::exp(x); }},
      {"logarithm", 0.1, 9.0, [](const Affine& x) { return logarithm(x); },
       [](double x) { return std::log(x); }},
      {"arc_cosine", -1.0, 1.0, [](const Affine& x) { return arc_cosine(x); },
       [](double x) { return std::acos(x); }},
      {"arc_tangent", -3.0, 3.0, [](const Affine& x) { return arc_tangent(x); },
       [](double x) { return std::atan(x); }},
      {"sine", -1.5, 1.5, [](const Affine& x) { return sine(x); },
       [](double x) { return std::sin(x); }},
      {"cosine", -1.5, 1.5, [](const Affine& x) { return cosine(x); },
       [](double x) { return std::cos(x); }},
      {"signed_square", -2.0, 2.0, [](const Affine& x) { return signed_square(x); },
       [](double x) { return x * std::abs(x); }},
      {"involute", 0.0, 1.2, [](const Affine& x) { return involute(x); },
       [](double x) { return x - std::atan(x); }},
      {"least", -1.0, 1.0, [](const Affine& x) { return least(x, Affine(0.3)); },
       [](double x) { return std::min(x, 0.3); }},
      {"greatest", -1.0, 1.0, [](const Affine& x) { return greatest(x, -0.5 * x); },
       [](double x) { return std::max(x, -0.5 * x); }},
      {"whole_rounding", 11.6, 12.3,
       [](const Affine& x) { return whole_rounding(x, 10.0, 0.1, 0.33); },
       [](double x) { return whole_rounding(x, 10.0, 0.1, 0.33); }}};
  return list;
}

/// f(x + y/2) with x and y the variables of the box.
TEST(Affine, EnclosesEveryFunction) {
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  for (const Case& each : cases()) {
    for (int trial = 0; trial < 300; ++trial) {
      // Boxes of any width, down to a millionth.
      const double span = each.high - each.low;
      const double width = span * std::pow(10.0, -6.0 * share(generator));
      const double low = each.low + (span - width) * share(generator);
      const double x_width = 0.5 * width, y_width = width;
      const Affine argument = variable(low, low + x_width, 0) + 0.5 * variable(0.0, y_width, 1);
      const Affine range = each.enclosed(argument);
      for (int point = 0; point < 20; ++point) {
        const double p = point == 0 ? 0.0 : point == 1 ? 1.0 : share(generator);
        const double q = point == 0 ? 0.0 : point == 1 ? 1.0 : share(generator);
        const double x = low + p * x_width + 0.5 * q * y_width;
        const double value = each.at(std::clamp(x, each.low, each.high));
        const double slack = 1e-12 * (1.0 + std::abs(value));
        ASSERT_GE(value, range.low - slack) << each.name << " " << low << " " << width;
        ASSERT_LE(value, range.high + slack) << each.name << " " << low << " " << width;
        if (!(range.rest < kInfinity)) continue;
        const double line =
            range.center + range.slope[0] * (2.0 * p - 1.0) + range.slope[1] * (2.0 * q - 1.0);
        ASSERT_LE(std::abs(value - line), range.rest + slack)
            << each.name << " " << low << " " << width;
      }
    }
  }
}

// The rest is what is left of a function beside its tangent: a quarter for half the box.
TEST(Affine, EnclosesNarrowBoxesToSecondOrder) {
  for (const Case& each : cases()) {
    const double middle = 0.7 * each.low + 0.3 * each.high;
    if (std::string_view(each.name) == "least" || std::string_view(each.name) == "greatest")
      continue;
    const auto rest = [&](double half) {
      return each.enclosed(variable(middle - half, middle + half, 0)).rest;
    };
    const double half = 0.02 * (each.high - each.low);
    EXPECT_LT(rest(0.5 * half), 0.3 * rest(half) + 1e-12) << each.name;
  }
}

// Oracle: the definitions, put back into themselves.
TEST(Affine, EnclosesWhatEquationsDefine) {
  std::mt19937 generator(2);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  for (int trial = 0; trial < 500; ++trial) {
    const double g0 = -0.1 + 0.15 * share(generator), h0 = -0.9 + 0.2 * share(generator);
    const double width = std::pow(10.0, -4.0 * share(generator)) * 0.04;
    const Affine g = variable(g0, g0 + width, 0), h = variable(h0, h0 + width, 1);
    const Affine angle = section_angle_rad(g, h);
    const Affine tangent = tangent_of_involute(variable(0.002 + 0.05 * share(generator), 0.06, 0));
    for (int point = 0; point < 10; ++point) {
      const double p = share(generator), q = share(generator);
      const double at_g = g0 + p * width, at_h = h0 + q * width;
      double theta = kPi / 6.0;
      for (int i = 0; i < 100; ++i) theta = at_g * std::tan(theta) - at_h;
      const double line =
          angle.center + angle.slope[0] * (2.0 * p - 1.0) + angle.slope[1] * (2.0 * q - 1.0);
      ASSERT_LE(std::abs(theta - line), angle.rest + 1e-12);
      ASSERT_GE(theta, angle.low - 1e-12);
      ASSERT_LE(theta, angle.high + 1e-12);
      const double t = tangent.low + p * (tangent.high - tangent.low);
      EXPECT_NEAR(tangent_of_involute(t - std::atan(t)), t, 1e-9);
    }
  }
}

TEST(Affine, SaysWhereAFunctionExistsNowhere) {
  EXPECT_TRUE(root(variable(-2.0, -1.0, 0)).is_nowhere());
  EXPECT_TRUE(arc_cosine(variable(1.5, 2.0, 0)).is_nowhere());
  EXPECT_TRUE((root(variable(-2.0, -1.0, 0)) + variable(0.0, 1.0, 1)).is_nowhere());
  const Affine part = root(variable(-1.0, 4.0, 0));
  EXPECT_LE(part.low, 0.0);
  EXPECT_GE(part.high, 2.0);
  EXPECT_FALSE((1.0 / variable(-1.0, 1.0, 0)).rest < kInfinity);
}

}  // namespace
}  // namespace torquewright::gearbox::sized
