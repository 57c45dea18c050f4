// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/oracles/sampled_bench/situation.hpp"

namespace torquewright::oracles::sampled {

/// What the log must show.
struct Needs {
  bool both_encoders = false;
  bool velocity = false;
  bool temperature = false;
  bool bus = false;       ///< Bus voltage and duty beside the current.
  bool is_quiet = false;  ///< Low noise.
};

/// Sensors and sampling of a bench whose plant and runs are known. Resolution and noise are such
/// that no channel but the torque, or the current, is what limits.
SamplingChain draw_chain(const Plant& plant, const std::vector<RunPlan>& runs, const Needs& needs,
                         Draw& draw);

}  // namespace torquewright::oracles::sampled
