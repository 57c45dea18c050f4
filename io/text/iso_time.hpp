// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>

namespace torquewright::io {

/// Seconds since 1970-01-01 00:00 of a date with a clock's time as ISO 8601 writes it,
/// "2026-11-28T18:00:00.25", a space in the place of T, with Z, an offset as +01:00, or neither
/// (then taken as Z). Empty if the text is none, or names a day or a time that does not exist.
std::optional<double> seconds_of_iso_time(std::string_view text);

}  // namespace torquewright::io
