// SPDX-License-Identifier: Apache-2.0
#include "io/columns/units_row.hpp"

#include <fmt/format.h>

#include <optional>
#include <string>

#include "io/faults/refusal.hpp"
#include "io/text/unit_in_name.hpp"
#include "io/text/wording.hpp"

namespace torquewright::io {

double with_units_row(const CsvReader& csv, std::size_t column, Dimension dimension, double factor,
                      bool is_stated) {
  if (csv.units().empty() || is_stated) return factor;
  const std::optional<Unit> in_row = find_unit(csv.units()[column]);
  if (!in_row) return factor;
  const std::string& name = csv.header()[column];
  if (in_row->dimension != dimension) {
    refuse(csv.file(), fmt::format("the row of units says {} at \"{}\", whose unit must be {}",
                                   in_row->name, name, either(unit_names(dimension))));
  }
  const std::optional<Unit> in_name = unit_in_name(name, dimension);
  if (!in_name) return factor * in_row->in_SI;
  if (in_name->name != in_row->name) {
    refuse(csv.file(), fmt::format("the name \"{}\" says {}, the row of units below it says {}; "
                                   "correct one or delete the row",
                                   name, in_name->name, in_row->name));
  }
  return factor;
}

}  // namespace torquewright::io
