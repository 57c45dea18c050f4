// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "identification/signals/preparation.hpp"

namespace torquewright::identification {

/// A number of a rig or an actuator that a pointer leads to ("/load/mass_kg", "/loads/RUN/mass_kg",
/// "/motor/torque_constant_Nm_A", "/gearbox/forward_efficiency"), for reading and for changing.
/// Null where there is none.
double* value_at(const std::string& pointer, Rig& rig, actuator::Actuator& actuator);

/// The joint that a pointer into a serial arm's rig speaks of does not matter: its links' values
/// enter every joint's torque.
bool is_of_load(const std::string& pointer);

}  // namespace torquewright::identification
