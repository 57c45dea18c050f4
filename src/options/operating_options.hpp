// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "actuator/motor/actuator_spec.hpp"
#include "actuator/region/operating_conditions.hpp"
#include "src/command_line/command_line.hpp"

namespace torquewright::cli {

/// The options by which a user says under which conditions an actuator works.
struct OperatingOptions {
  std::string rating = "peak";
  double bus_voltage_V = 0.0;          ///< 0: the document's.
  double state_of_charge = -1.0;       ///< Negative: full.
  double winding_temperature_K = 0.0;  ///< 0: the document's.
};

/// Adds --rating, --bus-voltage, --state-of-charge and --winding-temperature.
void add_operating_options(command_line::Command& command, OperatingOptions& options);

/// The conditions as the options state them.
actuator::OperatingConditions stated_conditions(const OperatingOptions& options);

/// Throws io::SpecError, at the file, where an actuator cannot be under them.
void require_possible(const actuator::Actuator& actuator, const std::string& file,
                      const actuator::OperatingConditions& conditions);

/// The conditions asked for. Throws io::SpecError, at the actuator's document, where the document
/// cannot meet them.
actuator::OperatingConditions conditions_of(const OperatingOptions& options,
                                            const actuator::ReadActuator& read);

}  // namespace torquewright::cli
