// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "hopper/replay_report/replay_report.hpp"
#include "src/commands/robot/hopper_check_inputs.hpp"
#include "src/options/hopper_replay_request.hpp"

namespace torquewright::cli {

/// The answer of `hopper replay` as a document.
std::string hopper_replay_json(const HopperReplayRequest& request, const HopperCheckInputs& inputs,
                               const hopper::Motion& motion, const hopper::ReplayReport& report);

/// SHA-256 of all that a trial depends on beside its number.
std::string hopper_trials_fingerprint(const HopperReplayRequest& request,
                                      const HopperCheckInputs& inputs,
                                      const hopper::Motion& motion);

}  // namespace torquewright::cli
