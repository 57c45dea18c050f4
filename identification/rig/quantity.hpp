// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string_view>

namespace torquewright::identification {

/// The quantity that a column of a log may hold. Signs and sides: docs/notation.md.
enum class Quantity {
  kTime,
  kRun,
  kOutputPosition,
  kOutputVelocity,
  kMotorPosition,
  kMotorVelocity,
  kMotorCurrent,  ///< In the actuator's convention of currents.
  kDuty,
  kWindingVoltage,
  kBusVoltage,
  kOutputTorque,    ///< Measured by an external sensor.
  kReportedTorque,  ///< The driver's own estimate, on the output's side.
  kCommandedTorque,
  kCommandedPosition,
  kWindingTemperature,
  kCaseTemperature,
  kEnabled,
  kLinearPosition,
  kLinearVelocity,
  kLinearForce,
  kFeedforwardTorque,  ///< Asked for beside what the joint's own controller makes of its position.
};
constexpr std::size_t kQuantityCount = 21;

/// Name as in documents: "time_s", "motor_current_A", ...
std::string_view name_of(Quantity quantity);
std::optional<Quantity> find_quantity(std::string_view name);

/// Unit at the end of its name: "A", "rad/s", "Nm", ...; empty where there is none.
std::string_view unit_of(Quantity quantity);

/// Whether the quantity is set, not measured: commanded torques and position, duty, `enabled`.
bool is_command(Quantity quantity);

}  // namespace torquewright::identification
