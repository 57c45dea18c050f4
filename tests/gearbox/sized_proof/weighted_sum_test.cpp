// SPDX-License-Identifier: Apache-2.0
// Oracle: a grid of points, on which the bound must not be above the least sum and must be near it.
#include "gearbox/sized_proof/enclosures/weighted_sum.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace torquewright::gearbox::sized {
namespace {

std::vector<LinearTerm> random_terms(unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  std::vector<LinearTerm> terms;
  const auto add = [&](TermKind kind, double constant) {
    terms.push_back({kind, constant, {any(generator), any(generator), any(generator)}});
  };
  for (int i = 0; i < 4; ++i) {
    add(TermKind::kFirstLayer, 4.0 + any(generator));
    add(TermKind::kSecondLayer, 4.0 + any(generator));
  }
  for (int i = 0; i < 4; ++i) add(TermKind::kCondition, -0.4 + any(generator));
  return terms;
}

double sum_at(const std::vector<LinearTerm>& terms, const std::array<double, 3>& point) {
  std::array<double, 2> most{};
  for (const LinearTerm& term : terms) {
    double value = term.constant;
    for (std::size_t i = 0; i < 3; ++i) value += term.slope[i] * point[i];
    if (term.kind == TermKind::kCondition) {
      if (value > 0.0) return HUGE_VAL;
      continue;
    }
    double& layer = most[static_cast<std::size_t>(term.kind)];
    layer = std::max(layer, value);
  }
  return most[0] + most[1];
}

TEST(WeightedSum, IsTheLeastOfAGrid) {
  constexpr int kSteps = 24;
  int near = 0, none = 0;
  constexpr int kCases = 80;
  for (unsigned seed = 1; seed <= kCases; ++seed) {
    const std::vector<LinearTerm> terms = random_terms(seed);
    const double proved = weigh(terms, 1e9).least;
    double least = HUGE_VAL;
    for (int i = 0; i <= kSteps; ++i) {
      for (int j = 0; j <= kSteps; ++j) {
        for (int k = 0; k <= kSteps; ++k) {
          const auto at = [](int step) { return 2.0 * step / kSteps - 1.0; };
          least = std::min(least, sum_at(terms, {at(i), at(j), at(k)}));
        }
      }
    }
    ASSERT_LE(proved, least) << seed;
    if (std::isinf(least)) {
      ++none;
    } else if (proved > least - 0.4) {  // Steps of 1/12, six slopes of at most 1.
      ++near;
    }
  }
  EXPECT_GT(none, 5);
  EXPECT_GE(near, kCases - none - 2);
}

TEST(WeightedSum, OfTermsThatContradictIsInfinite) {
  const std::vector<LinearTerm> terms{{TermKind::kFirstLayer, 1.0, {}},
                                      {TermKind::kSecondLayer, 1.0, {}},
                                      {TermKind::kCondition, 0.1, {1.0, 0.0, 0.0}},
                                      {TermKind::kCondition, 0.1, {-1.0, 0.0, 0.0}}};
  EXPECT_TRUE(std::isinf(weigh(terms, 10.0).least));
  EXPECT_NEAR(weigh({terms[0], terms[1]}, 10.0).least, 2.0, 1e-12);
}

}  // namespace
}  // namespace torquewright::gearbox::sized
