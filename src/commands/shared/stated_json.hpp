// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "src/command_line/declaration.hpp"

namespace torquewright::cli {

/// "options" of a result: what the options of the command that made it were, as each is declared to
/// be stated.
nlohmann::ordered_json stated_json(const command_line::DeclaredCommand& command);

/// "options" and what a result states elsewhere of them: what its fingerprint counts.
nlohmann::ordered_json counted_json(const command_line::DeclaredCommand& command);

}  // namespace torquewright::cli
