// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <set>
#include <string>
#include <vector>

#include "gearbox/problem.hpp"
#include "tests/oracles/fractions.hpp"

namespace torquewright::oracles {

/// Tooth counts. A single stage uses sun, planet_1 and fixed_ring; the others are 0.
struct Teeth {
  std::int64_t sun = 0;
  std::int64_t planet_1 = 0;
  std::int64_t planet_2 = 0;
  std::int64_t fixed_ring = 0;
  std::int64_t output_ring = 0;
};

/// The rings by coaxiality without profile shift.
Teeth complete_3k(std::int64_t sun, std::int64_t planet_1, std::int64_t planet_2);
Teeth complete_planetary(std::int64_t sun, std::int64_t planet);

/// Below this an irrational margin is not trusted: the point is reported as a near-tie.
inline constexpr long double kNearTie = 1e-15L;

/// What a rule says of one design. Where the margin is a fraction the answer is exact.
struct Judgement {
  bool holds = false;
  bool near_tie = false;   ///< Decided by a rounded margin of less than kNearTie.
  long double margin = 0;  ///< Only of irrational rules.
};

struct Rule {
  std::string name;  ///< As in docs/gearbox_constraints.md.
  std::function<Judgement(const Teeth&)> judge;
};

/// Names of constraints that are not enforced. A name without its last parts switches off all that
/// begin with it: "contact_ratio" stands for the three of them.
using Switches = std::set<std::string>;

/// One choice of what the loops over teeth hold fixed.
struct Setting {
  const gearbox::Problem& problem;
  std::int64_t planet_count;
  Rational module_mm;
};

/// Every constraint that the problem's set demands and that is not switched off.
std::vector<Rule> rules(const Setting& setting, const Switches& off);

/// Limits of the ratio, G (1 -+ t), in ascending order.
struct RatioRange {
  Fraction least;
  Fraction greatest;
};
RatioRange ratio_range(const gearbox::Problem& problem);

/// Input speed over output speed by Willis' equation, as a fraction with a positive denominator;
/// denominator 0 where the output stands still.
struct WideFraction {
  Wide numerator;
  Wide denominator;
};
WideFraction ratio_3k(const Teeth& teeth);
WideFraction ratio_planetary(const Teeth& teeth);

}  // namespace torquewright::oracles
