// SPDX-License-Identifier: Apache-2.0
#include "actuator/trajectory/units_row.hpp"

#include <fmt/format.h>

#include <optional>
#include <string>

#include "io/faults/refusal.hpp"
#include "io/text/unit_in_name.hpp"
#include "io/text/wording.hpp"

namespace torquewright::actuator {

io::Dimension dimension_of(Quantity quantity) {
  switch (quantity) {
    case Quantity::kTime:
      return io::Dimension::kTime;
    case Quantity::kPosition:
      return io::Dimension::kAngle;
    case Quantity::kVelocity:
      return io::Dimension::kAngularVelocity;
    case Quantity::kTorque:
      break;
  }
  return io::Dimension::kTorque;
}

double with_units_row(const io::CsvReader& csv, std::size_t column, io::Dimension dimension,
                      double factor, bool is_stated) {
  if (csv.units().empty() || is_stated) return factor;
  const std::optional<io::Unit> in_row = io::find_unit(csv.units()[column]);
  if (!in_row) return factor;
  const std::string& name = csv.header()[column];
  if (in_row->dimension != dimension) {
    io::refuse(csv.file(), fmt::format("the row of units says {} at \"{}\", whose unit must be {}",
                                       in_row->name, name, io::either(io::unit_names(dimension))));
  }
  const std::optional<io::Unit> in_name = io::unit_in_name(name, dimension);
  if (!in_name) return factor * in_row->in_SI;
  if (in_name->name != in_row->name) {
    io::refuse(csv.file(),
               fmt::format("the name \"{}\" says {}, the row of units below it says {}; state "
                           "which it is by --column, or delete the row",
                           name, in_name->name, in_row->name));
  }
  return factor;
}

}  // namespace torquewright::actuator
