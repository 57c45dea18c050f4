// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string_view>

namespace torquewright::identification {

/// What a column of a log may hold. Signs and sides: docs/notation.md.
enum class Quantity {
  kTime,
  kRun,
  kOutputPosition,
  kOutputVelocity,
  kMotorPosition,
  kMotorVelocity,
  kMotorCurrent,  ///< In the actuator's convention.
  kDuty,
  kWindingVoltage,
  kBusVoltage,
  kOutputTorque,    ///< By an external sensor.
  kReportedTorque,  ///< The driver's own estimate, output side.
  kCommandedTorque,
  kCommandedPosition,
  kWindingTemperature,
  kCaseTemperature,
  kEnabled,
  kLinearPosition,
  kLinearVelocity,
  kLinearForce,
};
constexpr std::size_t kQuantityCount = 20;

/// As in documents: "time_s", "motor_current_A", ...
std::string_view name_of(Quantity quantity);
std::optional<Quantity> find_quantity(std::string_view name);

/// The end of its name: "A", "rad/s", "Nm", ...; empty for what has none.
std::string_view unit_of(Quantity quantity);

/// Set, not measured: torque and position that are asked for, duty, `enabled`.
bool is_command(Quantity quantity);

}  // namespace torquewright::identification
