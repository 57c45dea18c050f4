// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "src/options/hopper_flip_request.hpp"

namespace torquewright::cli {

/// What to do with the answer, a line each: commands as a shell takes them.
std::vector<std::string> next_commands(const HopperFlipRequest& request,
                                       const hopper::PlanResult& result);

}  // namespace torquewright::cli
