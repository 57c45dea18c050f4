// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "src/exit_code.hpp"
#include "src/options/hopper_check_request.hpp"

namespace torquewright::cli {

/// `hopper check --sweep`: the check of the same motion for other robots.
ExitCode run_hopper_check_sweep(const HopperCheckRequest& request);

}  // namespace torquewright::cli
