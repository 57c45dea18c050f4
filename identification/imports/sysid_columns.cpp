// SPDX-License-Identifier: Apache-2.0
#include "identification/imports/sysid_columns.hpp"

#include <array>
#include <vector>

#include "identification/imports/named_columns.hpp"
#include "io/text/wording.hpp"

namespace torquewright::identification::imports {
namespace {

constexpr std::array kUnits = {
    PositionUnit{"Meters", true, 1.0},           PositionUnit{"Feet", true, 0.3048},
    PositionUnit{"Inches", true, 0.0254},        PositionUnit{"Radians", false, 1.0},
    PositionUnit{"Rotations", false, kTurn_rad}, PositionUnit{"Degrees", false, kTurn_rad / 360.0},
};

}  // namespace

const PositionUnit* find_position_unit(std::string_view name) {
  for (const PositionUnit& unit : kUnits) {
    if (unit.name == name) return &unit;
  }
  return nullptr;
}

std::string position_unit_names() {
  std::vector<std::string> names;
  for (const PositionUnit& unit : kUnits) names.emplace_back(unit.name);
  return io::listed(names);
}

void set_sysid_columns(const PositionUnit& unit, double per_count, ImportedLog& log) {
  const double scale = unit.in_SI * per_count;
  log.header = {"timestamp", "voltage", "position", "velocity"};
  log.columns = {
      {"timestamp", Quantity::kTime, 1.0, 0.0, ""},
      {"voltage", Quantity::kWindingVoltage, 1.0, 0.0, ""},
      {"position", unit.is_linear ? Quantity::kLinearPosition : Quantity::kOutputPosition, scale,
       0.0, ""},
      {"velocity", unit.is_linear ? Quantity::kLinearVelocity : Quantity::kOutputVelocity, scale,
       0.0, ""}};
}

}  // namespace torquewright::identification::imports
