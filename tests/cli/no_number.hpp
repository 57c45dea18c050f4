// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace torquewright::test {

/// Whether "nan", "inf", or JavaScript's "NaN" or "Infinity" stands in a text as a word of its own;
/// in a page outside of the library that draws on it.
bool says_no_number(const std::string& text);

}  // namespace torquewright::test
