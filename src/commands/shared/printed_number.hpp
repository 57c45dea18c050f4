// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace torquewright::cli {

/// A number as a sheet prints it, and what stands behind it.
struct PrintedNumber {
  double number = 0.0;
  std::string behind;  ///< Without the blanks before it.
  std::string fault;   ///< Why it is none, as the end of a sentence; empty: it is one.
};

/// Reads "1.17 ohm", "1,17 ohm", "3 820 rpm" and "6.1 x 10^-5 kg m2". "3,820" is refused, which may
/// be three thousand or three; a range ("24 to 48 V") too.
PrintedNumber printed_number(std::string_view text);

}  // namespace torquewright::cli
