// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "hopper/replay_report/replay_report.hpp"

namespace torquewright::hopper {

/// A document of kind `replay_report` without its provenance ("tool", "inputs", "options"). What is
/// not known is null.
nlohmann::ordered_json replay_report_json(const ReplayReport& report);

/// A trial on one line, as processes hand it on, and what such a line holds.
std::string trial_text(const TrialOutcome& outcome);
TrialOutcome trial_of(const std::string& text);

}  // namespace torquewright::hopper
