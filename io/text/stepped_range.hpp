// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "io/text/rational.hpp"

namespace torquewright::io {

/// Numbers from one to another in equal steps, both included where a step meets the last.
struct SteppedRange {
  Rational from;
  Rational to;
  Rational step = 1;
};

/// What is asked of numbers and ranges of one kind.
struct RangeRule {
  /// Is told why a text is none, and throws.
  std::function<void(const std::string& why)> refuse;
  std::size_t most = 0;         ///< Of values in a range, which has fewer.
  std::string what = "values";  ///< What they are called.
  double least = -std::numeric_limits<double>::max();
  double greatest = std::numeric_limits<double>::max();
};

/// Whether the text is of more than one number: it holds a colon.
bool is_range(const std::string& text);

/// Reads FROM:TO or FROM:TO:STEP, exactly; a step that is not written is 1. Refuses what is no
/// number, ends outside the limits or that do not ascend, a step not above 0, and too many values.
SteppedRange read_stepped_range(const std::string& text, const RangeRule& rule);

/// One decimal number, read as the ends of a range.
Rational read_range_number(const std::string& text, const RangeRule& rule);

/// Ascending.
std::vector<Rational> values_of(const SteppedRange& range);

}  // namespace torquewright::io
