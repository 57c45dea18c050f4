// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "actuator/effects/effect.hpp"
#include "io/faults/spec_error.hpp"

namespace torquewright::actuator {

/// Reads one member of "effects". Faults are added, at `file` and `path`; empty if there were any.
std::optional<Effect> read_effect(const nlohmann::json& entry, const std::string& file,
                                  const std::string& path, std::vector<io::Fault>& faults);

/// Writes the effect as a document states it.
nlohmann::ordered_json effect_json(const Effect& effect);

}  // namespace torquewright::actuator
