// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace torquewright::io {

/// A moment in s with so many digits, more where a clock has run for long: 0.612345, 1.5,
/// 12345.6789. With 6 digits at least tenths of a millisecond are told apart, with 4 hundredths of
/// a second.
std::string time_text(double time_s, int digits = 6);

}  // namespace torquewright::io
