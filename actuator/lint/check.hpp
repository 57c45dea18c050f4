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

/// How a stated number has to stand to what the others say.
enum class Demand { kEqual, kAtMost, kAtLeast };

/// What it is worth if it does not.
enum class Weight {
  kContradiction,
  kPlausibility,  ///< Possible, but worth a look: a note.
};

/// How well an explanation would do.
enum class Agreement {
  kFits,
  kAdmits,  ///< The stated speed stays below what is possible: loaded or capped.
  kExcludes,
};

/// One way in which the numbers would agree, or would not.
struct Explanation {
  std::string sentence;
  std::optional<RoundedInterval> expected;  ///< What the others would then say.
  Agreement fit = Agreement::kExcludes;
  std::string breaks = {};  ///< A rule that holds as stated and would not then; empty: none.
};

/// One thing that is stated twice: a number, and the others that it follows from. One of these per
/// rule, one line in library.cpp. The rules are listed in docs/lint.md.
struct Check {
  std::string_view rule;
  std::string_view unit;
  std::string_view equation;  ///< For a person, in the symbols of docs/lint.md.
  Demand demand = Demand::kEqual;
  Weight weight = Weight::kContradiction;
  std::optional<RoundedInterval> (*stated)(const Actuator& document) = nullptr;
  std::optional<RoundedInterval> (*expected)(const Interpretation& interpretation) = nullptr;
  std::vector<Interpreter>
      interpreters;            ///< Other interpretations that are tried on a contradiction.
  bool stands_alone = false;   ///< Of one number: no part of what explains the whole sheet.
  bool below_is_load = false;  ///< A smaller number may be a loaded or capped one.
  /// Explanations that are no interpretation of the document.
  std::vector<Explanation> (*further)(const Actuator& document, const RoundedInterval& stated,
                                      const RoundedInterval& expected) = nullptr;
  /// How far apart both may be without alarm; nullptr: not beyond their rounding.
  Tolerance (*tolerance)(const Compared& compared) = nullptr;
};

/// Every check there is.
std::span<const Check* const> library();

/// True if the two intervals meet the demand, within their rounding.
bool is_met(Demand demand, const RoundedInterval& stated, const RoundedInterval& expected);

/// The candidate table of a check for one document: each interpretation that changes what is
/// expected.
std::vector<Explanation> explanations(const Check& check, const Actuator& document);

/// Those of them that are no interpretation: a load, losses, a round number.
std::vector<Explanation> own_explanations(const Check& check, const Actuator& document,
                                          const RoundedInterval& stated,
                                          const RoundedInterval& expected);

}  // namespace torquewright::actuator::lint
