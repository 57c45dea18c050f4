// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "tests/fuzz/mutation.hpp"

namespace torquewright::fuzz {

/// A document in which one to three numbers are other ones, of any size: what schemas let pass and
/// formulas may not. A text that is no JSON, or has no number, is changed as by mutated().
std::string with_other_numbers(const std::string& text, Random& random);

}  // namespace torquewright::fuzz
