// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>

#include "identification/imports/importer.hpp"

namespace torquewright::identification::imports {

/// What a column of a known name is: quantity = scale cell + offset.
struct Meaning {
  Quantity quantity = Quantity::kTime;
  double scale = 1.0;
  double offset = 0.0;
};

inline constexpr double kTurn_rad = 6.283185307179586;
inline constexpr double kCelsius_K = 273.15;

/// CSV files whose names tell what they hold; a run each, by the file's name. Columns without a
/// meaning are ignored, and said. Throws io::SpecError where there is no time or nothing else,
/// where two columns mean the same, where a later file has other columns, and where a cell of a
/// column with a meaning is no finite number.
ImportedLog read_named_columns(
    const ImportRequest& request,
    const std::function<std::optional<Meaning>(const std::string& column)>& meaning_of);

/// The meaning of the longest of these endings ("pos_estimate") that stands at the end of the name,
/// behind nothing or a dot, slash or underscore.
struct Ending {
  std::string_view name;
  Meaning meaning;
};
std::optional<Meaning> by_ending(const std::string& column, std::span<const Ending> endings);

}  // namespace torquewright::identification::imports
