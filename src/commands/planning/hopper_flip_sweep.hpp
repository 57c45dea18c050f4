// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "src/exit_code.hpp"
#include "src/options/hopper_flip_request.hpp"

namespace torquewright::cli {

/// `hopper flip --sweep`: the same plan is looked for with other robots.
ExitCode run_hopper_flip_sweep(const HopperFlipRequest& request);

}  // namespace torquewright::cli
