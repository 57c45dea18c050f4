// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "actuator/trajectory/columns.hpp"
#include "io/files/csv.hpp"
#include "io/text/units.hpp"

namespace torquewright::actuator {

/// What a channel of a motion measures.
io::Dimension dimension_of(Quantity quantity);

/// What turns a column's numbers into SI units, where a row of units may stand under the header. It
/// counts for a column whose name says none; `is_stated`: the command line or a document says the
/// unit, and counts alone. Throws io::SpecError where the row contradicts the name or the quantity.
double with_units_row(const io::CsvReader& csv, std::size_t column, io::Dimension dimension,
                      double factor, bool is_stated);

}  // namespace torquewright::actuator
