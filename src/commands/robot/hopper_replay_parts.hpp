// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "hopper/trials/randomisation_spec.hpp"
#include "src/commands/robot/hopper_check_inputs.hpp"
#include "src/exit_code.hpp"
#include "src/options/hopper_replay_request.hpp"
#include "src/report/motion/replay_page.hpp"

namespace torquewright::cli {

/// What replays of motions and of policies have in common (hopper_replay.cpp).

/// Throws io::SpecError where files cannot be written.
void check_replay_files(const HopperReplayRequest& request);
/// Throws io::SpecError where options contradict each other.
void require_consistent(const HopperReplayRequest& request);
hopper::ReplayOptions replay_options(const HopperReplayRequest& request,
                                     const HopperCheckInputs& inputs);
/// What trials differ by; none where none are asked for.
std::optional<hopper::ReadRandomisation> read_trials(const HopperReplayRequest& request,
                                                     const hopper::Robot& robot);
hopper::ReplayedRun run_once(const hopper::Replay& replay, const char* what);
std::vector<hopper::SweptStep> sweep(const hopper::Replay& replay);
/// --series is of `of_trial` where it is there.
void write_answer(const HopperReplayRequest& request, const HopperCheckInputs& inputs,
                  const report::ReplayPage& page, const std::optional<hopper::Record>& of_trial);
/// Of the trials, or of the run where there are none.
ExitCode replay_code(const hopper::ReplayReport& report);

/// Whether a file is a document, as policies are, and no CSV.
bool names_policy(const std::string& file);
/// `hopper replay ROBOT POLICY`.
ExitCode run_policy_replay(const HopperReplayRequest& request);

}  // namespace torquewright::cli
