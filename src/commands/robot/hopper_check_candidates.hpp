// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "src/commands/robot/hopper_check_found.hpp"
#include "src/commands/robot/hopper_check_inputs.hpp"

namespace torquewright::cli {

/// Tries the candidates by processes, or ranks of mpirun: the same results as by threads.
/// None in a worker. Those whose process ended, or that Ctrl-C came before, are undecided.
std::optional<std::vector<hopper::CandidateResult>> try_by_processes(
    const HopperCheckRequest& request, const HopperCheckInputs& inputs,
    const HopperCheckFound& found);

}  // namespace torquewright::cli
