// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "actuator/lint/interpretation.hpp"
#include "actuator/lint/rounded_interval.hpp"
#include "actuator/lint/tolerance.hpp"

namespace torquewright::actuator::lint {

/// Relation that a stated number must have to the others.
enum class Demand { kEqual, kAtMost, kAtLeast };

/// Weight of a contradiction.
enum class Weight {
  kContradiction,
  kPlausibility,  ///< Possible, but worth a look: a note.
};

/// How well an explanation fits.
enum class Agreement {
  kFits,
  kAdmits,  ///< The stated speed stays below what is possible: loaded or capped.
  kExcludes,
};

/// A reading under which the numbers would agree, or would not.
struct Explanation {
  std::string sentence;
  std::optional<RoundedInterval> expected;  ///< The number that would then follow from the others.
  Agreement fit = Agreement::kExcludes;
  std::string breaks = {};  ///< A rule that holds as stated and would not hold then; empty: none.
};

/// A rule of the lint: a number that is stated twice, and the others that it follows from. Each has
/// one line in library.cpp; docs/lint.md lists them.
struct Check {
  std::string_view rule;
  std::string_view unit;
  std::string_view equation;  ///< The equation for a user, in the symbols of docs/lint.md.
  Demand demand = Demand::kEqual;
  Weight weight = Weight::kContradiction;
  std::optional<RoundedInterval> (*stated)(const Actuator& document) = nullptr;
  std::optional<RoundedInterval> (*expected)(const Interpretation& interpretation) = nullptr;
  std::vector<Interpreter> interpreters;  ///< Interpretations that are tried on a contradiction.
  /// Whether the check concerns one number alone, so that it does not count in what explains the
  /// whole sheet.
  bool stands_alone = false;
  bool below_is_load = false;  ///< A smaller number may be a loaded or capped one.
  /// Explanations that are no interpretation of the document.
  std::vector<Explanation> (*further)(const Actuator& document, const RoundedInterval& stated,
                                      const RoundedInterval& expected) = nullptr;
  /// How far apart both numbers may be without alarm; nullptr: no further than their rounding.
  Tolerance (*tolerance)(const Compared& compared) = nullptr;
};

/// Returns all rules.
std::span<const Check* const> library();

/// True if the two intervals meet the demand, within their rounding.
bool is_met(Demand demand, const RoundedInterval& stated, const RoundedInterval& expected);

/// Returns the candidate explanations of a check for one document: each interpretation that changes
/// the expected number.
std::vector<Explanation> explanations(const Check& check, const Actuator& document);

/// Returns the explanations that are no interpretation: a load, losses, a round number.
std::vector<Explanation> own_explanations(const Check& check, const Actuator& document,
                                          const RoundedInterval& stated,
                                          const RoundedInterval& expected);

}  // namespace torquewright::actuator::lint
