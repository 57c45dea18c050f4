// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include "actuator/lint/finding.hpp"

namespace torquewright::actuator::lint {

/// An explanation of all contradictions of a sheet at once. docs/lint.md, "Explanations".
struct JointExplanation {
  /// The fewest readings that together leave no contradiction; empty: no one and no two do.
  std::vector<std::string> readings;
  /// The smallest sets of numerals without which the rest agrees, where each comparison that agrees
  /// with a numeral counts as one more.
  std::vector<Numerals> culprits;
};

/// Both numbers of a check in one reading; empty where one of them is not stated.
struct Pair {
  RoundedInterval stated;
  RoundedInterval expected;
};
std::optional<Pair> pair_of(const Check& check, const Interpretation& interpretation);

/// Whether both are apart by no more than catalogues are, though by more than their rounding.
bool is_tolerated(const Check& check, const Actuator& document, const Pair& pair);

/// Returns the checks that contradict in one reading.
std::vector<const Check*> contradicted(const Interpretation& interpretation);

/// Finds the explanation. Requires the comparisons of that document, of which one contradicts.
JointExplanation explain(const Actuator& document, std::span<const Comparison> comparisons);

}  // namespace torquewright::actuator::lint
