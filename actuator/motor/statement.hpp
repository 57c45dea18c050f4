// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "actuator/motor/actuator.hpp"

namespace torquewright::actuator {

/// nullptr where a plain number stands.
const Statement* find_statement(const Actuator& actuator, std::string_view pointer);

/// The side of a number of the data sheet: its own, or else the sheet's. Requires a data sheet.
bool is_at_joint(const Actuator& actuator, std::string_view pointer);

/// Brings constants of the joint to the rotor (a torque constant over ratio and forward efficiency,
/// so that the joint has what was stated per ampere; a back-EMF constant over the ratio) and
/// currents into the torque constant's ampere. Numbers of the data sheet stay as they are printed.
void carry_to_motor(Actuator& actuator);

}  // namespace torquewright::actuator
