// SPDX-License-Identifier: Apache-2.0
// Oracle: a grid of points of the box, on which the bound must not be above the least of the masses
// and must be near it.
#include "gearbox/synthesis/linear_bound.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace torquewright::gearbox {
namespace {

constexpr int kGridSteps = 24;

struct RandomForms {
  std::array<LayerForms, 2> layers;
  std::vector<JointForm> joint;

  explicit RandomForms(unsigned seed) {
    std::mt19937 generator(seed);
    std::uniform_real_distribution<double> any(-1.0, 1.0);
    const auto form = [&](double constant) {
      return LinearForm{constant, {any(generator), any(generator)}};
    };
    for (LayerForms& layer : layers) {
      for (int i = 0; i < 4; ++i) layer.masses.push_back(form(5.0 + any(generator)));
      for (int i = 0; i < 2; ++i) layer.margins.push_back(form(0.3 + any(generator)));
      layer.middle = {0.1 * any(generator), 0.1 * any(generator)};
    }
    joint.push_back({0.2, {any(generator), any(generator), any(generator)}});
  }

  double at(const LinearForm& form, const LayerForms& layer, double centre, double shift) const {
    return form.constant + form.slopes[0] * (centre - layer.middle[0]) +
           form.slopes[1] * (shift - layer.middle[1]);
  }

  /// Both masses; infinite where a margin is negative.
  double mass(const std::array<double, 3>& point) const {
    double sum = 0.0;
    for (std::size_t i = 0; i < 2; ++i) {
      double most = 0.0;
      for (const LinearForm& form : layers[i].masses) {
        most = std::max(most, at(form, layers[i], point[0], point[i + 1]));
      }
      for (const LinearForm& form : layers[i].margins) {
        if (at(form, layers[i], point[0], point[i + 1]) < 0.0) return HUGE_VAL;
      }
      sum += most;
    }
    double left = joint[0].constant;
    for (std::size_t i = 0; i < 3; ++i) left += joint[0].slopes[i] * point[i];
    return left < 0.0 ? HUGE_VAL : sum;
  }
};

TEST(LinearBound, IsTheLeastOfAGrid) {
  int near = 0, empty = 0;
  constexpr int kCases = 60;
  for (unsigned seed = 1; seed <= kCases; ++seed) {
    const RandomForms forms(seed);
    const LinearBound bound = linear_bound({&forms.layers[0], &forms.layers[1]}, forms.joint,
                                           {Interval{-1.0, 1.0}, {-1.0, 1.0}, {-1.0, 1.0}});
    double least = HUGE_VAL;
    for (int i = 0; i <= kGridSteps; ++i) {
      for (int j = 0; j <= kGridSteps; ++j) {
        for (int k = 0; k <= kGridSteps; ++k) {
          const auto coordinate = [](int step) { return 2.0 * step / kGridSteps - 1.0; };
          least = std::min(least, forms.mass({coordinate(i), coordinate(j), coordinate(k)}));
        }
      }
    }
    EXPECT_LE(bound.mass_kg, least) << seed;
    if (std::isinf(least)) {
      ++empty;
    } else if (bound.mass_kg > least - 0.35) {  // Steps of 1/12, slopes of at most 1 in each.
      ++near;
    }
  }
  EXPECT_GT(near, 20);
  EXPECT_GE(near, kCases - empty - 2);
}

TEST(LinearBound, EnclosesWhatSlopesEnclose) {
  const InnerBox box{Interval{9.8, 10.3}, Interval{-0.1, 0.4}};
  const InnerPlace place(box);
  const Slope range = square(place.variable(0)) * exp(place.variable(1)) - 20.0;
  const LinearForm below = linear_below(range, place.offsets());
  const LinearForm above = linear_above(range, place.offsets());
  for (int i = 0; i <= 20; ++i) {
    for (int j = 0; j <= 20; ++j) {
      const double x = 9.8 + 0.025 * i, y = -0.1 + 0.025 * j;
      const double value = x * x * std::exp(y) - 20.0;
      const auto at = [&](const LinearForm& form) {
        return form.constant + form.slopes[0] * (x - place.middle()[0]) +
               form.slopes[1] * (y - place.middle()[1]);
      };
      EXPECT_LE(at(below), value);
      EXPECT_GE(at(above), value);
    }
  }
}

}  // namespace
}  // namespace torquewright::gearbox
