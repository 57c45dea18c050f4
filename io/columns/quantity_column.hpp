// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string_view>

#include "io/files/csv.hpp"
#include "io/text/units.hpp"

namespace torquewright::io {

/// A column that holds a quantity, and what turns its numbers into the SI unit.
struct QuantityColumn {
  std::size_t column = 0;
  double in_SI = 1.0;
};

/// Finds the column of that name, in small letters: "speed" is meant by speed_rad_s, "Speed [rpm]"
/// and, over a row of units, Speed. Throws SpecError where none or several are, or no unit of the
/// dimension is stated.
QuantityColumn quantity_column(const CsvReader& csv, std::string_view name, Dimension dimension);

}  // namespace torquewright::io
