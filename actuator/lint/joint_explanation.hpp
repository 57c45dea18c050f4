// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include "actuator/lint/finding.hpp"

namespace torquewright::actuator::lint {

/// What explains a whole sheet, all of its contradictions at once. docs/lint.md, "Explanations".
struct JointExplanation {
  /// The fewest that together leave no contradiction; empty: no two and no one does.
  std::vector<std::string> readings;
  /// Sets of numerals without which the rest agrees: those that are the fewest, where each
  /// comparison that agrees with a numeral counts as one more.
  std::vector<Numerals> culprits;
};

/// Both numbers of a check in one reading; nothing where one of them is not stated.
struct Pair {
  RoundedInterval stated;
  RoundedInterval expected;
};
std::optional<Pair> pair_of(const Check& check, const Interpretation& interpretation);

/// Whether both are apart by no more than catalogues are, though by more than their rounding.
bool is_tolerated(const Check& check, const Actuator& document, const Pair& pair);

/// The checks that contradict in one reading.
std::vector<const Check*> contradicted(const Interpretation& interpretation);

/// Requires the comparisons of that document, of which one contradicts.
JointExplanation explain(const Actuator& document, std::span<const Comparison> comparisons);

}  // namespace torquewright::actuator::lint
