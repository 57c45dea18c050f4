// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "src/commands/hopper_check_found.hpp"
#include "src/commands/hopper_check_inputs.hpp"

namespace torquewright::cli {

/// The report as a document of kind check_report.
std::string hopper_check_json(const HopperCheckRequest& request, const HopperCheckInputs& inputs,
                              const HopperCheckFound& found);

}  // namespace torquewright::cli
