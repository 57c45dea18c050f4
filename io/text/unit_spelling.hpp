// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace torquewright::io {

/// A unit as sheets and loggers print it, in the letters of this program's tables: "mohm" of "mΩ",
/// "Nm/A" of "N·m/A", "rpm" of "min⁻¹" or "r/min", "ozf_in" of "oz-in". Capitals that would mean
/// another unit stay: "nm" is no torque. What is not known comes back without blanks and dots.
std::string unit_spelling(std::string_view printed);

}  // namespace torquewright::io
