// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "hopper/training/episode/hopper_environment.hpp"

namespace torquewright::hopper {

/// An environment of a trainer's, as far as its training still knows it.
struct StagedCopy {
  std::unique_ptr<HopperEnvironment> environment;
  std::size_t asked_stage = 0;  ///< Of the next episode,
  std::size_t stage = 0;        ///< and of the present one.
};

/// What the trainer owns of it: begins each episode by the options of the stage that is asked for.
/// The stages must outlive it.
std::unique_ptr<learning::Environment> staged_environment(
    std::shared_ptr<StagedCopy> copy, const std::vector<EpisodeOptions>& stages);

}  // namespace torquewright::hopper
