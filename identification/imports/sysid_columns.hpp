// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "identification/imports/importer.hpp"

namespace torquewright::identification::imports {

/// A unit in which SysId measures positions.
struct PositionUnit {
  std::string_view name;
  bool is_linear = false;
  double in_SI = 1.0;  ///< Size of the unit in m or rad.
};

/// Finds a unit by its name; nullptr for a name that SysId does not have.
const PositionUnit* find_position_unit(std::string_view name);

/// Returns all names for a message: "Meters, Feet, ..."
std::string position_unit_names();

/// Sets the four columns of every SysId test, where positions count `per_count` of the unit.
void set_sysid_columns(const PositionUnit& unit, double per_count, ImportedLog& log);

}  // namespace torquewright::identification::imports
