// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>

#include "robot/mechanisms/mechanism_type_spec.hpp"

namespace torquewright::hopper {

/// All that documents may name.
std::span<const MechanismType* const> mechanism_types();

/// Adds a fault for each key of other types, and for each one that is needed and missing; whether
/// there was none.
bool has_right_keys(const MechanismType& type, const MechanismKeys& keys);

/// A mechanism's own keys in a document, beside type, joints and actuators.
nlohmann::ordered_json mechanism_keys(const Mechanism& mechanism);

}  // namespace torquewright::hopper
