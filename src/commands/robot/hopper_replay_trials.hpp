// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "hopper/replay_report/replay_report.hpp"
#include "hopper/trials/randomisation_spec.hpp"
#include "src/options/hopper_replay_request.hpp"

namespace torquewright::cli {

/// Runs the trials that were asked for: by threads; by processes, or ranks of mpirun, where jobs, a
/// journal or ranks were named. The outcomes are the same. None in a worker, which ends without a
/// word. `fingerprint` is of all that a trial depends on beside its number.
std::optional<hopper::ReplayTrials> run_replay_trials(const hopper::Replay& replay,
                                                      const hopper::Randomisation& randomisation,
                                                      const HopperReplayRequest& request,
                                                      const std::string& fingerprint);

/// Runs as many trials again for each thing that varies, alone, and notes what they come to.
void explain_trials(const hopper::Replay& replay, const hopper::Randomisation& randomisation,
                    const HopperReplayRequest& request, hopper::ReplayTrials& trials);

/// Of the trial that --trial asks for alone, by time, for --series; none where all were asked for,
/// or no series.
std::optional<hopper::Record> record_of_asked_trial(
    const hopper::Replay& replay, const std::optional<hopper::ReadRandomisation>& randomised,
    const HopperReplayRequest& request);

}  // namespace torquewright::cli
