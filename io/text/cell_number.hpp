// SPDX-License-Identifier: Apache-2.0
// Numbers as tables print them.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace torquewright::io {

/// The whole text as a double, infinities and NaN included; a number too small for one is 0.
/// Exponents may be Fortran's: 1.5D-3.
std::optional<double> number_of(std::string_view text);

/// 1,5 or -0,25e3 with a point in the place of the one comma; empty if that is no number.
std::string with_point(std::string_view text);

}  // namespace torquewright::io
