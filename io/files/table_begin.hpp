// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

namespace torquewright::io {

/// Where a table seems to begin in a file that has other lines before it.
struct TableBegin {
  std::size_t line = 0;  ///< Of the names, from 1.
  std::string names;     ///< That line, cut off where it is long.
};

/// Looks at the first lines for one of names before two of numbers, all of as many cells; empty:
/// the first line is it, or none is.
std::optional<TableBegin> find_table_begin(const std::string& file);

}  // namespace torquewright::io
