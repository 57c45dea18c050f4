// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace torquewright::io {

/// A computed number with the digits that are known of it: twelve, of `scale` where that is greater
/// (the greatest of its column, the limit that it stands under). What lies behind them is what
/// rounding left: 319.99999999999994 becomes 320, 8e-15 beside 320 becomes 0, -0 becomes 0.
double known(double value, double scale = 0.0);

/// As a table has it: the shortest decimal of that.
std::string known_text(double value, double scale = 0.0);

/// As a file for another program has it, which may compute on: the shortest decimal that reads back
/// the same, but for a last unit that arithmetic left in the place of a short decimal:
/// 0.012249999999999999 becomes 0.01225.
std::string precise_text(double value);

}  // namespace torquewright::io
