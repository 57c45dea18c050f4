// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "tests/fuzz/program/case.hpp"

namespace torquewright::fuzz {

/// Whether a smaller case still breaks the same rule.
using StillBreaks = std::function<bool(const Case&)>;

/// The case with as little as can be left away piece by piece, in at most so many trials: files
/// that are as in the examples again, words that are gone, halves, quarters, ... of what files
/// hold, and parts of documents.
Case minimised(Case one, const StillBreaks& still_breaks, int most_trials);

}  // namespace torquewright::fuzz
