// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "identification/draft/rig_draft.hpp"

namespace torquewright::identification {

/// Returns the draft as a document of kind rig; what was guessed stands under `assumed`.
nlohmann::ordered_json rig_draft_json(const RigDraft& draft, const std::string& name);

}  // namespace torquewright::identification
