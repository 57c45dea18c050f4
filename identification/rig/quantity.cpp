// SPDX-License-Identifier: Apache-2.0
#include "identification/rig/quantity.hpp"

namespace torquewright::identification {
namespace {

struct Entry {
  std::string_view name;
  std::string_view unit;
};

/// In the order of Quantity.
constexpr std::array<Entry, kQuantityCount> kEntries = {{
    {"time_s", "s"},
    {"run", ""},
    {"output_position_rad", "rad"},
    {"output_velocity_rad_s", "rad/s"},
    {"motor_position_rad", "rad"},
    {"motor_velocity_rad_s", "rad/s"},
    {"motor_current_A", "A"},
    {"duty", ""},
    {"winding_voltage_V", "V"},
    {"bus_voltage_V", "V"},
    {"output_torque_Nm", "Nm"},
    {"reported_torque_Nm", "Nm"},
    {"commanded_torque_Nm", "Nm"},
    {"commanded_position_rad", "rad"},
    {"winding_temperature_K", "K"},
    {"case_temperature_K", "K"},
    {"enabled", ""},
    {"linear_position_m", "m"},
    {"linear_velocity_m_s", "m/s"},
    {"linear_force_N", "N"},
    {"feedforward_torque_Nm", "Nm"},
}};

}  // namespace

std::string_view name_of(Quantity quantity) {
  return kEntries[static_cast<std::size_t>(quantity)].name;
}

std::optional<Quantity> find_quantity(std::string_view name) {
  for (std::size_t i = 0; i < kEntries.size(); ++i) {
    if (kEntries[i].name == name) return static_cast<Quantity>(i);
  }
  return std::nullopt;
}

std::string_view unit_of(Quantity quantity) {
  return kEntries[static_cast<std::size_t>(quantity)].unit;
}

bool is_command(Quantity quantity) {
  switch (quantity) {
    case Quantity::kDuty:
    case Quantity::kCommandedTorque:
    case Quantity::kCommandedPosition:
    case Quantity::kEnabled:
    case Quantity::kFeedforwardTorque:
      return true;
    default:
      return false;
  }
}

}  // namespace torquewright::identification
