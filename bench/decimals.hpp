// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "io/text/rational.hpp"

namespace torquewright::bench {

/// "79.4" is 397/5. Digits and at most one point; throws std::invalid_argument otherwise.
io::Rational from_decimal(const std::string& text);

/// The shortest decimal, for fractions that are decimals of at most 15 places.
std::string to_decimal(const io::Rational& value);

}  // namespace torquewright::bench
