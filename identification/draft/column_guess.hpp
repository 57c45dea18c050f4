// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "identification/draft/column_words.hpp"
#include "identification/rig/quantity.hpp"

namespace torquewright::identification {

/// What a column of a log is taken for, and why.
struct ColumnGuess {
  std::string column;
  std::optional<Quantity> quantity;  ///< Empty: the column is to be ignored.
  std::optional<io::Unit> unit;      ///< Empty: the quantity's own, or not known yet.
  std::string joint;                 ///< The words of its name that are left; empty: none are.
  std::string why;                   ///< A clause that says what it was taken by.
  bool is_sure = false;              ///< Its own name says quantity and unit.
  bool is_reversed = false;          ///< Its sign is against that of the position.
};

/// Returns what a column is taken for by its name and the unit under it alone.
ColumnGuess guess_by_name(const std::string& column, const std::string& unit_below);

}  // namespace torquewright::identification
