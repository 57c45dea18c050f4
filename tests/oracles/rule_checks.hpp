// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "tests/oracles/gearbox_enumeration.hpp"
#include "tests/oracles/named_problems.hpp"

namespace torquewright::oracles {

/// A buildable 3k problem that forbids as little as possible, to try one rule at a time.
inline gearbox::Problem generous(std::int64_t planets, const Rational& ratio) {
  gearbox::Problem problem = paper_problem({1, 1, 1}, Rational(-4));
  problem.constraints = gearbox::ConstraintSet::kBuildable;
  problem.rotor_inner_diameter_mm = 600;
  problem.planet_count = {planets};
  problem.target_ratio = ratio;
  problem.min_contact_ratio = 0;
  return problem;
}

inline bool violates(const gearbox::Problem& problem, const std::vector<std::int64_t>& teeth,
                     const std::string& name) {
  const auto list =
      violations(problem, {teeth, problem.planet_count.at(0), problem.module_mm.at(0)});
  return std::find(list.begin(), list.end(), name) != list.end();
}

inline std::vector<std::int64_t> zero_shift(std::int64_t s, std::int64_t p1, std::int64_t p2) {
  return {s, p1, p2, s + 2 * p1, s + p1 + p2};
}

}  // namespace torquewright::oracles
