// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "hopper/tracking/every_controller.hpp"

namespace torquewright::hopper {

/// Returns all controllers, in the order in which help and messages list them.
const std::vector<const ControllerKind*>& every_controller();
std::vector<std::string> controller_names();

/// Returns the controller of that name. std::invalid_argument where there is none: options allow no
/// other word.
const ControllerKind& controller_named(std::string_view name);

}  // namespace torquewright::hopper
