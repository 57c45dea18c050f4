// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "hopper/engines/every_engine.hpp"

namespace torquewright::hopper {

/// Returns all engines, in the order in which help and messages list them.
const std::vector<const EngineKind*>& every_engine();
std::vector<std::string> engine_names();

/// Returns the engine of that name. std::invalid_argument where there is none: options allow no
/// other word.
const EngineKind& engine_named(std::string_view name);

}  // namespace torquewright::hopper
