// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "hopper/trials/explanation.hpp"
#include "src/commands/planning/hopper_flip_inputs.hpp"
#include "src/commands/robot/hopper_replay_parts.hpp"
#include "src/options/hopper_flip_request.hpp"

namespace torquewright::cli {

/// How each plan of a sweep is tried: as `hopper replay --trials` would, with its defaults where
/// nothing else is asked for.
struct PlanTrials {
  HopperReplayRequest replay;
  hopper::ReadRandomisation read;
};

/// None where no trials are asked for. Throws io::SpecError where the document does not fit the
/// robot or varies nothing, or the engine cannot hold it.
std::optional<PlanTrials> read_plan_trials(const HopperFlipRequest& request,
                                           const HopperFlipInputs& inputs);

/// A sweep's points have a process each, and one thread.
enum class TrialThreads { kOne, kAll };

/// Replays a plan of the robot as often as asked for. The outcomes are those of `hopper replay` of
/// the plan's file, for any number of threads. Throws io::SpecError where it cannot be replayed.
hopper::TrialOutcomes outcomes_of(const PlanTrials& trials, const hopper::CheckOptions& check,
                                  const hopper::Robot& robot, const hopper::PlanResult& plan,
                                  TrialThreads threads);

}  // namespace torquewright::cli
