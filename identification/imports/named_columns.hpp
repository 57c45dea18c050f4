// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>

#include "identification/imports/importer.hpp"

namespace torquewright::identification::imports {

/// What a column of a known name means: quantity = scale cell + offset.
struct Meaning {
  Quantity quantity = Quantity::kTime;
  double scale = 1.0;
  double offset = 0.0;
};

inline constexpr double kTurn_rad = 6.283185307179586;
inline constexpr double kCelsius_K = 273.15;

/// Reads CSV files whose column names tell what they hold; each file is a run of the file's name.
/// Columns without a meaning are ignored with a note. Throws io::SpecError where there is no time
/// or nothing else, where two columns mean the same, where a later file has other columns, and
/// where a cell of a column with a meaning is no finite number; a column that has none at all, and
/// rows of other topics (nothing but a time of what is read), are left out with a note.
ImportedLog read_named_columns(
    const ImportRequest& request,
    const std::function<std::optional<Meaning>(const std::string& column)>& meaning_of);

/// The meaning of a column whose name ends so ("pos_estimate"), behind nothing or a dot, slash or
/// underscore. The longest ending counts.
struct Ending {
  std::string_view name;
  Meaning meaning;
};
std::optional<Meaning> by_ending(const std::string& column, std::span<const Ending> endings);

}  // namespace torquewright::identification::imports
