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

/// Looks at the first lines for one of names before two of numbers, all of as many cells, between
/// which one of units may stand; empty: the first line is it, or none is. LabVIEW's last column,
/// Comment, may have no cells.
std::optional<TableBegin> find_table_begin(const std::string& file);

/// How many lines a recorder wrote before the line of names: lines of other lengths than that one,
/// none of which holds two numbers. 0: the first line has the names, or where it stands is not
/// sure.
std::size_t lines_before_table(const std::string& file);

}  // namespace torquewright::io
