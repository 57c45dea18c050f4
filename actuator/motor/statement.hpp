// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "actuator/motor/convention.hpp"

namespace torquewright::actuator {

struct Actuator;

/// What a document says of one of its numbers beside the number:
/// {"value": 2.36, "side": "joint", "ampere": "rms", "tolerance": 0.1}.
struct Statement {
  std::string pointer;                      ///< "/motor/torque_constant_Nm_A"
  double printed = 0.0;                     ///< The number as it stands there.
  std::optional<bool> at_joint;             ///< Else as the key, or the data sheet, has it.
  std::optional<CurrentConvention> ampere;  ///< Else the torque constant's.
  std::optional<double> tolerance;          ///< Share of the number, either way.
};

/// nullptr where a plain number stands.
const Statement* find_statement(const Actuator& actuator, std::string_view pointer);

/// The side of a number of the data sheet: its own, or else the sheet's. Requires a data sheet.
bool is_at_joint(const Actuator& actuator, std::string_view pointer);

/// Brings constants of the joint to the rotor (a torque constant over ratio and forward efficiency,
/// so that the joint has what was stated per ampere; a back-EMF constant over the ratio) and
/// currents into the torque constant's ampere. Numbers of the data sheet stay as they are printed.
void carry_to_motor(Actuator& actuator);

}  // namespace torquewright::actuator
