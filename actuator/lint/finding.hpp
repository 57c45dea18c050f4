// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "actuator/lint/check.hpp"
#include "actuator/severity.hpp"

namespace torquewright::actuator::lint {

/// A number that is stated twice, and whether both statements agree within their rounding.
struct Comparison {
  std::string rule;
  std::string unit;
  std::string equation;
  Demand demand = Demand::kEqual;
  RoundedInterval stated;
  RoundedInterval expected;
  bool agrees = true;
  bool is_tolerated = true;  ///< They are apart by no more than catalogues are.
  Weight weight = Weight::kContradiction;
};

using Numerals = std::vector<std::string>;  ///< Printed numbers, named by their pointers.

struct Finding {
  Severity severity = Severity::kNote;
  std::string rule;
  std::string actuator;  ///< Name of the actuator, or names.
  std::string unit;
  std::string sentence;
  RoundedInterval stated;            ///< What is stated, with its pointers.
  RoundedInterval expected;          ///< What follows from others, with their pointers.
  std::vector<std::string> assumed;  ///< Pointers that the document lists as assumed.
  std::vector<Explanation> explanations;
  /// The fewest other readings that together resolve the contradiction; empty: none do, or there is
  /// no contradiction.
  std::vector<std::string> explained_by;
  std::vector<Numerals> culprits;  ///< Sets of numbers, each of which alone would spoil the sheet.
};

/// Returns the bound of the expected interval that is nearest to what is stated.
double limit(const Finding& finding);

/// Writes a number with its interval and unit: 20 (19.5 to 20.5) rad/s.
std::string with_interval(const RoundedInterval& interval, std::string_view unit);

/// Joins sets of numerals: "A", "A or B and C", ...
std::string either(const std::vector<Numerals>& sets);

/// Returns the severity: warning if an explanation fits or admits, violation if none does.
Severity contradiction(const std::vector<Explanation>& explanations);

}  // namespace torquewright::actuator::lint
