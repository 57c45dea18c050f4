// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "tests/oracles/sampled_bench/bench.hpp"

namespace torquewright::oracles::sampled {

enum class Richness {
  kRich,      ///< Both directions, speeds 10:1, loads of both signs and several levels.
  kOneSpeed,  ///< One speed, one direction, one load.
  kOneLoad,   ///< Speeds of both directions, one load.
  kOneSine,   ///< One sinusoid throughout.
};

/// What the bench does in each of a log's runs. `warm`: runs begin at different temperatures.
std::vector<RunPlan> draw_runs(const Plant& plant, Richness richness, bool warm, Draw& draw);

}  // namespace torquewright::oracles::sampled
