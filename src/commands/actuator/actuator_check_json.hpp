// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "actuator/drive_check/report.hpp"
#include "src/commands/actuator/actuator_check_inputs.hpp"

namespace torquewright::cli {

/// The report as a document of kind check_report.
std::string actuator_check_json(const CheckOptions& options, const ActuatorCheckInputs& inputs,
                                const actuator::CheckReport& report);

}  // namespace torquewright::cli
