// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "identification/preparation/preparation.hpp"

namespace torquewright::identification {

/// Finds a number of a rig or an actuator by its pointer ("/load/mass_kg", "/loads/RUN/mass_kg",
/// "/motor/torque_constant_Nm_A", "/gearbox/forward_efficiency"), to read or change it. Null where
/// there is none.
double* value_at(const std::string& pointer, Rig& rig, actuator::Actuator& actuator);

/// Whether a pointer leads to the load. For a serial arm the joint does not matter: its links'
/// values enter every joint's torque.
bool is_of_load(const std::string& pointer);

}  // namespace torquewright::identification
