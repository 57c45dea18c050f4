// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "robot/mechanisms/loop_geometry.hpp"
#include "robot/mechanisms/mechanism_type_spec.hpp"

namespace torquewright::hopper {

/// The keys links, closures and, if they are there, turned, about the joints that are named; empty
/// where faults were added or joints are missing. It closes (ClosedLinks::objection()).
std::optional<LoopGeometry> read_loop_geometry(const MechanismKeys& keys);

/// The same keys.
nlohmann::ordered_json loop_geometry_keys(const LoopGeometry& loop);

}  // namespace torquewright::hopper
