// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "io/files/csv.hpp"
#include "io/text/units.hpp"

namespace torquewright::io {

/// What turns a column's numbers into SI units, where a row of units may stand under the header. It
/// counts for a column whose name says none, beside `factor`; `is_stated`: the command line or a
/// document says the unit, and counts alone. Throws SpecError where the row contradicts the name or
/// the dimension.
double with_units_row(const CsvReader& csv, std::size_t column, Dimension dimension, double factor,
                      bool is_stated);

}  // namespace torquewright::io
