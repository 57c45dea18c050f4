// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "gearbox/constraints/design_report.hpp"

namespace torquewright::gearbox {

enum class Sense { kAtLeast, kMoreThan, kAtMost };

/// A constraint at one design before it is judged. Value and limit are fractions, so that
/// "satisfied" is decided exactly.
struct DesignCondition {
  std::string name;
  std::string key = {};   ///< JSON pointer of the bound; empty: none.
  std::string unit = {};  ///< "teeth" and "1" are printed without a unit of measure.
  Sense sense = Sense::kAtLeast;
  Rational value = {};
  Rational limit = {};
  std::string meaning = {};  ///< Meaning of the value: "between neighbouring planets' tips".
  std::string remedy = {};   ///< What would mend a violation: "needs n <= 3".
};

/// Judges a condition: value, limit, margin and sentence.
ConstraintReport judge(const DesignCondition& condition);

/// Returns the report of a condition whose value does not exist: violated, value 0, margin -1,
/// `reason` as its sentence.
ConstraintReport violated_without_value(const DesignCondition& condition,
                                        const std::string& reason);

/// Returns the fraction that a floating-point number is. Long doubles keep all their digits: angles
/// are judged against decimals that may agree with them to sixteen digits.
Rational fraction_of(long double value);

/// Writes a fraction as sentences print it: "0.2618 rad", "44 teeth".
std::string with_unit(const Rational& value, const std::string& unit);

}  // namespace torquewright::gearbox
